#include "pbrt/films/film.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr IntParam kXResolution{"xresolution", 1280, 1, kMaxResolution, "pixels across"};
constexpr IntParam kYResolution{"yresolution", 720, 1, kMaxResolution, "pixels down"};
constexpr ArrayParam kPixelBounds{"pixelbounds", "integer", "all pixels",
                                  "x0 x1 y0 y1: render these pixels only"};
constexpr ArrayParam kCropWindow{
    "cropwindow", "float", "the whole picture",
    "x0 x1 y0 y1 in [0, 1]: render this part only; outranks pixelbounds"};
constexpr StringParam kFileName{"filename", "pbrt.exr", "the picture to write: .exr, .png or .pfm"};
constexpr BoolParam kSaveFp16{"savefp16", true, "16-bit floats in .exr files, else 32-bit ones"};

PixelBounds Crop(Point2i full, const std::array<float, 4> &c) {
    const auto edge = [](float f, int n) {
        return int(std::ceil(std::clamp(f, 0.f, 1.f) * float(n)));
    };
    return {edge(c[0], full.x), edge(c[1], full.x), edge(c[2], full.y), edge(c[3], full.y)};
}

PixelBounds ReadBounds(ParamDict &params, const FilmOverrides &overrides, Point2i full) {
    PixelBounds bounds{0, full.x, 0, full.y};
    const std::vector<int> given = params.GetIntArray(kPixelBounds);
    std::vector<float> crop = params.GetFloatArray(kCropWindow);
    const auto clip = [&](const auto &b) {
        return PixelBounds{std::clamp(b[0], 0, full.x), std::clamp(b[1], 0, full.x),
                           std::clamp(b[2], 0, full.y), std::clamp(b[3], 0, full.y)};
    };
    if (!given.empty() && given.size() != 4)
        params.Error(kPixelBounds.name, "\"pixelbounds\" needs four integers: x0 x1 y0 y1");
    else if (!given.empty())
        bounds = clip(given);
    if (!crop.empty() && crop.size() != 4)
        params.Error(kCropWindow.name, "\"cropwindow\" needs four numbers in [0, 1]: x0 x1 y0 y1");
    else if (!crop.empty())
        bounds = Crop(full, {crop[0], crop[1], crop[2], crop[3]});
    if (!given.empty() && !crop.empty())
        params.Warning(kPixelBounds.name, "\"pixelbounds\" has no effect: \"cropwindow\" counts");
    if (overrides.pixelBounds && overrides.cropWindow)
        params.Log().Warning({}, "--pixelbounds and --pixel have no effect: --cropwindow counts");
    if (overrides.pixelBounds) bounds = clip(*overrides.pixelBounds);
    if (overrides.cropWindow) bounds = Crop(full, *overrides.cropWindow);
    if (bounds.Width() <= 0 || bounds.Height() <= 0) {
        params.Error("no pixels are left by \"cropwindow\" or \"pixelbounds\"");
        bounds = {0, full.x, 0, full.y};
    }
    return bounds;
}

std::string ReadFileName(ParamDict &params, const FilmOverrides &overrides, bool exrOnly) {
    const std::string written = params.GetOneString(kFileName);
    const bool overridden = !overrides.outfile.empty();
    const std::string &name = overridden ? overrides.outfile : written;
    const auto refuse = [&](const std::string &why) {
        if (overridden)
            params.Log().Error({}, fmt::format("--outfile: cannot write \"{}\": {}", name, why));
        else
            params.Error(kFileName.name, fmt::format("cannot write \"{}\": {}", name, why));
    };
    if (!CanWriteImage(name))
        refuse("the name must end in .exr, .png or .pfm");
    else if (exrOnly && !name.ends_with(".exr"))
        refuse(params.What() + " needs the many channels of .exr");
    return name;
}

}  // namespace

Film Film::Create(const SceneDescription &scene, const FilmOverrides &overrides, Diagnostics &log) {
    const std::string name =
        scene.film.type.empty() ? std::string(RGBFilm::kName) : scene.film.type;
    ParamDict params(scene.film.params, scene.film.loc, fmt::format("film \"{}\"", name),
                     scene.film.colorSpace, &log, scene.dir);
    return Create(name, params, overrides);
}

Film Film::Create(std::string_view type, ParamDict &params, const FilmOverrides &overrides) {
    Film film;
    film.forDenoiserOnly = overrides.denoised && type == RGBFilm::kName;
    if (film.forDenoiserOnly) type = GBufferFilm::kName;
    Point2i full{params.GetOneInt(kXResolution), params.GetOneInt(kYResolution)};
    if (overrides.quick) full = {std::max(1, full.x / 4), std::max(1, full.y / 4)};
    film.fullResolution = full;
    film.bounds = ReadBounds(params, overrides, full);
    const bool known = FilmTypes::Visit(type, [&]<typename F>() {
        film.type = F::Create(params);
        film.traits = F::kTraits;
    });
    if (!known) {
        params.Error(UnknownName("film", type, FilmTypes::kNames));
        return film;
    }
    film.fileName = ReadFileName(params, overrides, film.traits.exrOnly && !film.forDenoiserOnly);
    film.colorSpace = &params.ColorSpace();
    film.format = params.GetOneBool(kSaveFp16) ? ExrPixels::Half : ExrPixels::Float;
    film.sensor = Sensor::Create(params, *film.colorSpace);
    params.ReportUnused();
    const PixelBounds &b = film.bounds;
    if (const auto why = WhyTooLarge(film.BytesFor(b))) {
        params.Error(fmt::format("a film of {} x {} pixels with {} channels {}", b.Width(),
                                 b.Height(), film.ChannelNames().size(), *why));
        film.bounds = {0, 1, 0, 1};
    }
    return film;
}

std::optional<Film> Film::ForSums(std::string_view type, size_t sumsPerPixel) {
    Diagnostics log;
    ParsedParameters parameters;
    // The only film whose sums depend on its parameters: two for a bucket.
    if (type == SpectralFilm::kName && sumsPerPixel > 4) {
        ParsedParameter &buckets = parameters.emplace_back();
        buckets.type = "integer";
        buckets.name = "nbuckets";
        buckets.ints = {int(std::min<size_t>(sumsPerPixel, kMaxResolution) / 2) - 2};
    }
    ParamDict params(parameters, {}, "film", &RGBColorSpace::sRGB(), &log);
    Film film = Create(type, params, {});
    if (log.HasErrors() || film.SumsPerPixel() != sumsPerPixel) return {};
    film.bounds = {0, 1, 0, 1};
    return film;
}

std::string_view Film::TypeName() const {
    return Dispatch(type, []<typename F>(const F &) -> std::string_view { return F::kName; });
}

void Film::SetSpaces(const Transform &camera, const Transform &world) {
    Dispatch(type, [&](auto &t) { t.SetSpaces(camera, world); });
}

uint64_t Film::BytesFor(const PixelBounds &b) const {
    // The image, a copy in the file's type, the file; the sums.
    return uint64_t(b.Area()) *
           (ChannelNames().size() * 3 * sizeof(float) + SumsPerPixel() * sizeof(ExactSum));
}

std::vector<std::string> Film::ChannelNames() const {
    std::vector<std::string> names{"R", "G", "B"};
    for (std::string &name : Dispatch(type, [](const auto &t) { return t.ChannelNames(); }))
        names.push_back(std::move(name));
    return names;
}

Film::Pixel Film::NewPixel() const {
    Pixel pixel;
    Dispatch(type, [&](const auto &t) { pixel.more = t.NewSums(); });
    return pixel;
}

size_t Film::SumsPerPixel() const {
    size_t n = 4;
    Pixel pixel = NewPixel();
    std::visit([&](auto &more) { more.ForEach([&](const ExactSum &) { ++n; }); }, pixel.more);
    return n;
}

void Film::Flatten(Pixel pixel, ExactSum *to) const {
    to = std::copy(pixel.rgb.begin(), pixel.rgb.end(), to);
    *to++ = pixel.weight;
    std::visit([&](auto &more) { more.ForEach([&](const ExactSum &s) { *to++ = s; }); },
               pixel.more);
}

Film::Pixel Film::Unflatten(const ExactSum *from) const {
    Pixel pixel = NewPixel();
    std::copy_n(from, pixel.rgb.size(), pixel.rgb.begin());
    from += pixel.rgb.size();
    pixel.weight = *from++;
    std::visit([&](auto &more) { more.ForEach([&](ExactSum &s) { s = *from++; }); }, pixel.more);
    return pixel;
}

void Film::AddMore(Pixel *pixel, SampledSpectrum L, const RGB &rgb,
                   const SampledWavelengths &lambda, float weight,
                   const VisibleSurface *surface) const {
    FilmSample sample{rgb, {}, lambda, weight, surface, {}};
    if (traits.spectral) sample.exposed = sensor.Exposed(L);
    if (surface) sample.albedo = sensor.ColorOf(surface->albedo, lambda);
    Dispatch(type, [&]<typename F>(const F &t) {
        t.Add(std::get_if<typename F::Sums>(&pixel->more), sample);
    });
}

Image Film::NewImage() const {
    Image image({bounds.Width(), bounds.Height()}, ChannelNames());
    image.metadata.pixelBounds = {bounds.x0, bounds.x1, bounds.y0, bounds.y1};
    image.metadata.fullResolution = fullResolution;
    if (colorSpace != &RGBColorSpace::sRGB())
        image.metadata.chromaticities = colorSpace->Chromaticities();
    Dispatch(type, [&](const auto &t) { t.WriteMetadata(&image.metadata.strings); });
    return image;
}

void Film::Develop(Point2i p, const Pixel &pixel, Image *image) const {
    Develop(pixel, image->Pixel({p.x - bounds.x0, p.y - bounds.y0}));
}

void Film::Develop(const Pixel &pixel, float *channels) const {
    const double weight = pixel.Weight();
    for (int c = 0; c < 3; ++c)
        channels[c] = weight == 0 ? 0 : float(pixel.Mean(c));
    Dispatch(type, [&]<typename F>(const F &t) {
        t.Write(*std::get_if<typename F::Sums>(&pixel.more), channels + 3);
    });
}

}  // namespace pbrt
