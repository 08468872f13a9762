#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pbrt/films/gbuffer.h"
#include "pbrt/films/spectral.h"
#include "pbrt/image/image.h"
#include "pbrt/scene/description.h"
#include "pbrt/spectra/color.h"

namespace pbrt {

/// Most pixels along a side of a picture.
inline constexpr int kMaxResolution = 1 << 16;

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

/// The films: the CIE 1931 observer as sensor, colours of the film's colour space; film `rgb` keeps
/// nothing else, `gbuffer` and `spectral` have further channels.
class Film {
  public:
    static Film Create(const SceneDescription &scene, const FilmOverrides &overrides,
                       Diagnostics &log);

    /// Shutter time in seconds: the imaging ratio is seconds * iso / 100.
    void SetExposure(float seconds) { imagingRatio = seconds * iso / 100; }

    Point2i FullResolution() const { return fullResolution; }
    const PixelBounds &Bounds() const { return bounds; }
    const std::string &FileName() const { return fileName; }
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }

    /// The transforms from rendering to camera and world space.
    void SetSpaces(const Transform &camera, const Transform &world) {
        if (auto *const g = std::get_if<GBuffer>(&aovs)) g->SetSpaces(camera, world);
    }
    /// Whether AddSample makes use of a VisibleSurface.
    bool WantsSurface() const { return std::holds_alternative<GBuffer>(aovs); }
    /// Of one path; u in [0, 1).
    SampledWavelengths SampleWavelengths(float u) const {
        if (const auto *s = std::get_if<SpectralBuckets>(&aovs)) [[unlikely]]
            return s->SampleWavelengths(u);
        return SampledWavelengths::SampleVisible(u);
    }

    /// Sums of one pixel; kept by its tile, stored once.
    struct Pixel {
        double rgb[3] = {};
        double weight = 0;
        std::variant<std::monostate, SpectralBuckets::Sums, GBuffer::Sums> aovs;
    };
    Pixel NewPixel() const;
    /// Sensor response to L sampled at lambda: mean over the wavelengths of L times the matching
    /// curves over the pdf, in the film's space, clamped to `maxcomponentvalue`, times the imaging
    /// ratio. Wavelengths of pdf 0 (terminated) do not count.
    RGB ToSensorRGB(SampledSpectrum L, const SampledWavelengths &lambda) const;
    /// `surface`: what the path saw first, null where nothing or nobody WantsSurface.
    void AddSample(Pixel *pixel, SampledSpectrum L, const SampledWavelengths &lambda, float weight,
                   const VisibleSurface *surface = nullptr) const {
        const RGB rgb = ToSensorRGB(L, lambda);
        for (int c = 0; c < 3; ++c)
            pixel->rgb[c] += weight * rgb[c];
        pixel->weight += weight;
        if (aovs.index() != 0) [[unlikely]]
            AddAOVs(pixel, L, rgb, lambda, weight, surface);
    }
    void Store(Point2i p, const Pixel &pixel);
    RGB PixelRGB(Point2i p) const;

    Image ToImage() const;
    ExrPixels Format() const { return format; }

  private:
    /// RGB of L by the matching curves, neither exposed nor clamped.
    FloatX4 Matched(SampledSpectrum L, const SampledWavelengths &lambda) const;
    std::vector<std::string> AOVNames() const;
    /// Memory that the pixels take until the picture is written, all at a time: sums, picture,
    /// file.
    uint64_t BytesFor(const PixelBounds &b) const;
    void AddAOVs(Pixel *pixel, SampledSpectrum L, const RGB &rgb, const SampledWavelengths &lambda,
                 float weight, const VisibleSurface *surface) const;
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
    struct Sum {
        double rgb[3] = {};
        double weight = 0;
    };
    std::vector<Sum> pixels;
    std::variant<std::monostate, SpectralBuckets, GBuffer> aovs;
    std::vector<std::string> aovChannels;
    std::vector<float> aovValues;  ///< pixel by pixel
    Spectrum illuminant;           ///< white of luminance 1, that albedos are seen under
};

}  // namespace pbrt
