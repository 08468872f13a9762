#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/films/exact_sum.h"
#include "pbrt/films/gbuffer.h"
#include "pbrt/films/rgb.h"
#include "pbrt/films/sensor.h"
#include "pbrt/films/spectral.h"
#include "pbrt/image/image.h"
#include "pbrt/scene/description.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of film types; base/film.h has their contract.
using FilmTypes = TypeList<RGBFilm, GBufferFilm, SpectralFilm>;
static_assert(FilmTypes::All([]<typename F>() { return FilmType<F>; }));

/// Most pixels along a side of an image.
inline constexpr int kMaxResolution = 1 << 16;

/// Half-open rectangle of pixels.
struct PixelBounds {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    int Width() const { return x1 - x0; }
    int Height() const { return y1 - y0; }
    int64_t Area() const { return int64_t(Width()) * Height(); }
    bool Contains(Point2i p) const { return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1; }
    bool operator==(const PixelBounds &) const = default;
};

/// Film settings that the command line overrides.
struct FilmOverrides {
    std::string outfile;
    std::optional<std::array<float, 4>> cropWindow;
    std::optional<std::array<int, 4>> pixelBounds;
    bool quick = false;  ///< a quarter of the resolution
    /// Film "rgb" gathers what "gbuffer" does, to guide the denoiser, into whatever kind of file.
    bool denoised = false;
};

/// Settings of the image: values, pixels, file. Immutable while rendering. Samples are summed up in
/// Pixel objects that the caller owns, and developed into an image.
class Film {
  public:
    static Film Create(const SceneDescription &scene, const FilmOverrides &overrides,
                       Diagnostics &log);
    /// The same by its parameters.
    static Film Create(std::string_view type, ParamDict &params, const FilmOverrides &overrides);
    /// A film of one pixel to develop sums with; nullopt where no film of this type has so many.
    static std::optional<Film> ForSums(std::string_view type, size_t sumsPerPixel);

    // Before rendering.
    /// Shutter time in seconds.
    void SetExposure(float seconds) { sensor.SetExposure(seconds); }
    /// The transforms from rendering to camera and world space.
    void SetSpaces(const Transform &camera, const Transform &world);

    Point2i FullResolution() const { return fullResolution; }
    /// The pixels that are wanted, of the full resolution's.
    const PixelBounds &Bounds() const { return bounds; }
    const std::string &FileName() const { return fileName; }
    /// True where the channels beside R, G and B are for the denoiser only (FilmOverrides).
    bool ForDenoiserOnly() const { return forDenoiserOnly; }
    const RGBColorSpace &ColorSpace() const { return *colorSpace; }
    ExrPixels Format() const { return format; }

    /// True where Samples::Add makes use of a VisibleSurface.
    bool WantsSurface() const { return traits.surface; }
    /// Wavelengths of one path; u in [0, 1).
    SampledWavelengths SampleWavelengths(float u) const {
        if (std::holds_alternative<RGBFilm>(type)) [[likely]]
            return SampledWavelengths::SampleVisible(u);
        return Dispatch(type, [u](const auto &t) { return t.SampleWavelengths(u); });
    }

    /// Sums of one pixel's samples; their order and grouping do not matter.
    struct Pixel {
        std::array<ExactSum, 3> rgb;
        ExactSum weight;
        std::variant<RGBFilm::Sums, GBufferFilm::Sums, SpectralFilm::Sums> more;

        double Weight() const { return weight.Value(); }
        double Mean(int c) const { return rgb[size_t(c)].Value() / weight.Value(); }
    };
    Pixel NewPixel() const;
    /// How many sums make up a pixel. Pixels of two sets of samples, each as a list of so many
    /// sums, make up that of all samples where they are added one by one.
    size_t SumsPerPixel() const;
    void Flatten(Pixel pixel, ExactSum *to) const;
    Pixel Unflatten(const ExactSum *from) const;
    /// Samples on their way into a pixel. Those of one object are summed up in double precision,
    /// one after another, and added to the exact sums together, which is faster: so their order and
    /// grouping do matter, and must be those of a piece's samples.
    class Samples {
      public:
        Samples(const Film &film, Pixel *pixel) : film(film), pixel(pixel) {}
        /// Radiance L sampled at lambda with the filter's weight. `surface`: what the path saw
        /// first, null where nothing or nobody WantsSurface.
        void Add(SampledSpectrum L, const SampledWavelengths &lambda, float weight,
                 const VisibleSurface *surface = nullptr) {
            const RGB response = film.sensor.Response(L, lambda);
            for (int c = 0; c < 3; ++c)
                rgb[size_t(c)] += double(weight) * response[c];
            sumOfWeights += weight;
            if (!std::holds_alternative<RGBFilm>(film.type)) [[unlikely]]
                film.AddMore(pixel, L, response, lambda, weight, surface);
        }
        /// Once, after the last.
        void Finish() const {
            for (size_t c = 0; c < 3; ++c)
                pixel->rgb[c] += rgb[c];
            pixel->weight += sumOfWeights;
        }

      private:
        const Film &film;
        Pixel *pixel;
        std::array<double, 3> rgb{};
        double sumOfWeights = 0;
    };

    /// An image of Bounds(), black, with the channels and attributes of the film.
    Image NewImage() const;
    /// Sets pixel p of such an image, p in pixels of the full resolution.
    void Develop(Point2i p, const Pixel &pixel, Image *image) const;
    /// The same into the values of one pixel.
    void Develop(const Pixel &pixel, float *channels) const;
    std::string_view TypeName() const;

  private:
    void AddMore(Pixel *pixel, SampledSpectrum L, const RGB &rgb, const SampledWavelengths &lambda,
                 float weight, const VisibleSurface *surface) const;
    std::vector<std::string> ChannelNames() const;
    /// Memory that the pixels take until the image is written, all at a time.
    uint64_t BytesFor(const PixelBounds &b) const;

    Point2i fullResolution{1280, 720};
    PixelBounds bounds;
    std::string fileName = "pbrt.exr";
    const RGBColorSpace *colorSpace = &RGBColorSpace::sRGB();
    ExrPixels format = ExrPixels::Half;
    Sensor sensor;
    FilmTypes::Variant type;
    FilmTraits traits;
    bool forDenoiserOnly = false;
};

}  // namespace pbrt
