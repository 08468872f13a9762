#pragma once

#include "pbrt/image/image.h"

// What convert does to values and pixels. Channel A (opacity) keeps its values everywhere.

namespace pbrt::imgtool {

template <typename F>
void ForEachValue(Image *image, F f) {
    const int alpha = image->ChannelIndex("A"), n = image->NChannels();
    for (size_t i = 0; i < image->Data().size(); ++i)
        if (int(i % n) != alpha) image->Data()[i] = f(image->Data()[i]);
}

/// Mean of the channels of a pixel but A; the pixel's n values begin at p.
float MeanValue(const float *p, int n, int alpha);

/// One channel Y, the mean of the channels, and A where there is one.
Image Gray(const Image &image);
/// Pixels whose mean is above `threshold` become, channel by channel, the median of the 3 x 3
/// pixels about them.
Image Despike(const Image &image, float threshold);
/// Reinhard et al. 2002, eq. 4, with the mean as luminance and `white` the mean that becomes 1.
void Reinhard(Image *image, float white);
/// Pixels with a value above 1 are divided by their largest.
void ScaleIntoGamut(Image *image);
/// Narkowicz 2015, "ACES Filmic Tone Mapping Curve"; result in [0, 1].
float AcesFilmic(float v);
Image RepeatPixels(const Image &image, int n);
/// Rows in reverse order.
Image FlipY(const Image &image);

}  // namespace pbrt::imgtool
