#pragma once

#include <array>
#include <string>
#include <vector>

#include "pbrt/image/image.h"
#include "pbrt/scene/description.h"
#include "pbrt/spectra/color.h"

namespace pbrt {

/// Half-open rectangle of pixels.
struct PixelBounds {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    int Width() const { return x1 - x0; }
    int Height() const { return y1 - y0; }
    int64_t Area() const { return int64_t(Width()) * Height(); }
};

/// What the command line overrides of the film.
struct FilmOverrides {
    std::string outfile;
    std::optional<std::array<float, 4>> cropWindow;
    std::optional<std::array<int, 4>> pixelBounds;
    bool quick = false;  ///< a quarter of the resolution
};

/// The `rgb` film: the CIE 1931 observer as sensor, colours of the film's colour space.
class RGBFilm {
  public:
    static constexpr std::string_view kName = "rgb";
    static RGBFilm Create(const Description &scene, const FilmOverrides &overrides,
                          Diagnostics &log);

    /// Shutter time in seconds: the imaging ratio is seconds * iso / 100.
    void SetExposure(float seconds) { imagingRatio = seconds * iso / 100; }

    Point2i FullResolution() const { return fullResolution; }
    const PixelBounds &Bounds() const { return bounds; }
    const std::string &FileName() const { return fileName; }
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }

    /// Sums of one pixel; kept by its tile, stored once.
    struct Pixel {
        double rgb[3] = {};
        double weight = 0;
    };
    /// Sensor response to L sampled at lambda: mean over the wavelengths of L times the matching
    /// curves over the pdf, in the film's space, clamped to `maxcomponentvalue`, times the imaging
    /// ratio. Wavelengths of pdf 0 (terminated) do not count.
    RGB ToSensorRGB(SampledSpectrum L, const SampledWavelengths &lambda) const;
    void AddSample(Pixel *pixel, SampledSpectrum L, const SampledWavelengths &lambda,
                   float weight) const {
        const RGB rgb = ToSensorRGB(L, lambda);
        for (int c = 0; c < 3; ++c) pixel->rgb[c] += weight * rgb[c];
        pixel->weight += weight;
    }
    void Store(Point2i p, const Pixel &pixel) { pixels[Index(p)] = pixel; }
    RGB PixelRGB(Point2i p) const;

    Image ToImage() const;
    ExrPixels Format() const { return format; }

  private:
    size_t Index(Point2i p) const {
        return size_t(p.y - bounds.y0) * bounds.Width() + (p.x - bounds.x0);
    }
    Point2i fullResolution{1280, 720};
    PixelBounds bounds;
    std::string fileName = "pbrt.exr";
    const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
    float iso = 100, imagingRatio = 1, maxComponentValue = Infinity;
    ExrPixels format = ExrPixels::Half;
    /// Per whole nm from 360: the film's r, g, b matching curves (the fourth is padding) over the
    /// number of wavelengths.
    std::vector<std::array<float, 4>> matching;
    std::vector<Pixel> pixels;
};

}  // namespace pbrt
