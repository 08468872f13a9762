#include "pbrt/films/film.h"

#include <fmt/format.h>

#include <cmath>

#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr std::string_view kRGB = "rgb";
constexpr std::array<std::string_view, 3> kFilms{kRGB, GBuffer::kName, SpectralBuckets::kName};
constexpr std::array<std::string_view, 1> kSensors{"cie1931"};
constexpr FloatParam kIso{"iso", "", 100, 1e-6f, 1e9f, "sensor speed"};
constexpr FloatParam kMaxComponent{"maxcomponentvalue",        "", Infinity, 0, Infinity,
                                   "largest value of a sample"};
constexpr FloatParam kWhiteBalance{"whitebalance", "K", 0, 0, 25000, "0: none"};
constexpr FloatParam kDiagonal{"diagonal", "mm", 35, 1e-6f, 1e6f, "of the film"};

PixelBounds Crop(Point2i full, const std::array<float, 4> &c) {
    const auto edge = [](float f, int n) {
        return int(std::ceil(std::clamp(f, 0.f, 1.f) * float(n)));
    };
    return {edge(c[0], full.x), edge(c[1], full.x), edge(c[2], full.y), edge(c[3], full.y)};
}

PixelBounds ReadBounds(ParamDict &params, const FilmOverrides &overrides, Point2i full) {
    PixelBounds bounds{0, full.x, 0, full.y};
    const std::vector<int> given = params.GetIntArray("pixelbounds");
    std::vector<float> crop = params.GetFloatArray("cropwindow");
    const auto clip = [&](const auto &b) {
        return PixelBounds{std::clamp(b[0], 0, full.x), std::clamp(b[1], 0, full.x),
                           std::clamp(b[2], 0, full.y), std::clamp(b[3], 0, full.y)};
    };
    if (!given.empty() && given.size() != 4)
        params.Error("pixelbounds", "\"pixelbounds\" needs four integers: x0 x1 y0 y1");
    else if (!given.empty())
        bounds = clip(given);
    if (!crop.empty() && crop.size() != 4)
        params.Error("cropwindow", "\"cropwindow\" needs four numbers in [0, 1]: x0 x1 y0 y1");
    else if (!crop.empty())
        bounds = Crop(full, {crop[0], crop[1], crop[2], crop[3]});
    if (!given.empty() && !crop.empty())
        params.Warning("pixelbounds", "\"pixelbounds\" has no effect: \"cropwindow\" counts");
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

std::string ReadFileName(ParamDict &params, const FilmOverrides &overrides, bool manyChannels) {
    const std::string written = params.GetOneString("filename", "pbrt.exr");
    const bool overridden = !overrides.outfile.empty();
    const std::string &name = overridden ? overrides.outfile : written;
    const auto refuse = [&](const std::string &why) {
        if (overridden)
            params.Log().Error({}, fmt::format("--outfile: cannot write \"{}\": {}", name, why));
        else
            params.Error("filename", fmt::format("cannot write \"{}\": {}", name, why));
    };
    if (!CanWriteImage(name))
        refuse("the name must end in .exr, .png or .pfm");
    else if (manyChannels && !name.ends_with(".exr"))
        refuse(params.What() + " needs the many channels of .exr");
    return name;
}

/// Matching curves in the film's RGB over the number of wavelength samples. Not over the integral
/// of y: lights are (PBRT_FORMAT 2.10), so that a light of 1 gives a pixel of 1.
std::vector<std::array<float, 4>> Matching(const RGBColorSpace &space, float whiteBalance) {
    Matrix3 adapt{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (whiteBalance > 0) {
        const std::array<double, 2> xy = DaylightChromaticity(whiteBalance);
        adapt = WhiteBalance({float(xy[0]), float(xy[1])}, space.Chromaticities()[3]);
    }
    std::vector<std::array<float, 4>> table(int(LambdaMax - LambdaMin) + 1);
    constexpr float scale = 1.f / NSpectrumSamples;
    for (size_t i = 0; i < table.size(); ++i) {
        const float lambda = LambdaMin + float(i);
        const std::array<float, 3> xyz =
            Mul(adapt, {spectra::X()(lambda), spectra::Y()(lambda), spectra::Z()(lambda)});
        const std::array<float, 3> rgb = Mul(space.RGBFromXYZ(), xyz);
        table[i] = {rgb[0] * scale, rgb[1] * scale, rgb[2] * scale, 0};
    }
    return table;
}

}  // namespace

Film Film::Create(const SceneDescription &scene, const FilmOverrides &overrides, Diagnostics &log) {
    const std::string type = scene.film.type.empty() ? std::string(kRGB) : scene.film.type;
    ParamDict params(scene.film.params, scene.film.loc, fmt::format("film \"{}\"", type),
                     scene.film.colorSpace, &log, scene.dir);
    Film film;
    if (std::find(kFilms.begin(), kFilms.end(), type) == kFilms.end()) {
        params.Error(UnknownName("film", type, kFilms));
        return film;
    }
    Point2i full{params.GetOneInt("xresolution", 1280, 1, kMaxResolution),
                 params.GetOneInt("yresolution", 720, 1, kMaxResolution)};
    if (overrides.quick) full = {std::max(1, full.x / 4), std::max(1, full.y / 4)};
    film.fullResolution = full;
    film.bounds = ReadBounds(params, overrides, full);
    if (type == GBuffer::kName) film.aovs = GBuffer::Create(params);
    if (type == SpectralBuckets::kName) film.aovs = SpectralBuckets::Create(params);
    film.aovChannels = film.AOVNames();
    film.fileName = ReadFileName(params, overrides, !film.aovChannels.empty());
    film.colorSpace = scene.film.colorSpace;
    film.iso = params.GetOneFloat(kIso);
    film.maxComponentValue = params.GetOneFloat(kMaxComponent);
    film.format = params.GetOneBool("savefp16", true) ? ExrPixels::Half : ExrPixels::Float;
    params.GetOneFloat(kDiagonal);  // concerns realistic cameras only
    params.GetOneChoice("sensor", "cie1931", kSensors);
    const float white = params.GetOneFloat(kWhiteBalance);
    if (white != 0 && white < 4000)
        params.Error("whitebalance", "\"whitebalance\" must be 0 or from 4000 to 25000 K");
    film.matching = Matching(*film.colorSpace, white);
    const Spectrum &illuminant = film.colorSpace->Illuminant();
    film.illuminant = illuminant.Scaled(1 / SpectrumToPhotometric(illuminant));
    params.ReportUnused();
    const PixelBounds &b = film.bounds;
    if (const auto why = WhyTooLarge(film.BytesFor(b))) {
        params.Error(fmt::format("a film of {} x {} pixels with {} channels {}", b.Width(),
                                 b.Height(), 3 + film.aovChannels.size(), *why));
        film.bounds = {0, 1, 0, 1};
    }
    film.pixels.resize(size_t(film.bounds.Area()));
    film.aovValues.resize(film.pixels.size() * film.aovChannels.size());
    return film;
}

uint64_t Film::BytesFor(const PixelBounds &b) const {
    const size_t channels = 3 + aovChannels.size();
    const size_t sums = sizeof(Sum) + aovChannels.size() * sizeof(float);
    // The picture, a copy in the file's type, the file.
    return uint64_t(b.Area()) * (sums + channels * 3 * sizeof(float));
}

FloatX4 Film::Matched(SampledSpectrum L, const SampledWavelengths &lambda) const {
    const SampledSpectrum pdf = lambda.PDF();
    FloatX4 sum{};
    for (int i = 0; i < NSpectrumSamples; ++i) {
        if (pdf[i] == 0) continue;
        const float at = lambda[i] - LambdaMin;
        const int k = std::min(int(at), int(LambdaMax - LambdaMin) - 1);
        const float t = at - float(k);
        const float *a = matching[k].data(), *b = matching[k + 1].data();
        const FloatX4 va{a[0], a[1], a[2], a[3]}, vb{b[0], b[1], b[2], b[3]};
        sum += (va + (vb - va) * t) * (L[i] / pdf[i]);
    }
    return sum;
}

RGB Film::ToSensorRGB(SampledSpectrum L, const SampledWavelengths &lambda) const {
    FloatX4 sum = Matched(L, lambda) * imagingRatio;
    const float largest = std::max(sum[0], std::max(sum[1], sum[2]));
    if (largest > maxComponentValue) sum *= maxComponentValue / largest;
    return {sum[0], sum[1], sum[2]};
}

std::vector<std::string> Film::AOVNames() const {
    if (const auto *g = std::get_if<GBuffer>(&aovs)) return g->ChannelNames();
    if (const auto *s = std::get_if<SpectralBuckets>(&aovs)) return s->ChannelNames();
    return {};
}

Film::Pixel Film::NewPixel() const {
    Pixel pixel;
    if (const auto *g = std::get_if<GBuffer>(&aovs)) pixel.aovs = g->NewSums();
    if (const auto *s = std::get_if<SpectralBuckets>(&aovs)) pixel.aovs = s->NewSums();
    return pixel;
}

void Film::AddAOVs(Pixel *pixel, SampledSpectrum L, const RGB &rgb,
                   const SampledWavelengths &lambda, float weight,
                   const VisibleSurface *surface) const {
    if (auto *const sums = std::get_if<SpectralBuckets::Sums>(&pixel->aovs)) {
        SampledSpectrum exposed = L * (imagingRatio * CIE_Y_integral);
        const float largest = exposed.MaxComponentValue();
        if (largest > maxComponentValue) exposed *= maxComponentValue / largest;
        std::get<SpectralBuckets>(aovs).Add(sums, exposed, lambda, weight);
    } else if (auto *const sums = std::get_if<GBuffer::Sums>(&pixel->aovs)) {
        RGB albedo;
        if (surface) {
            const auto c = Matched(surface->albedo * illuminant.Sample(lambda), lambda);
            albedo = {c[0], c[1], c[2]};
        }
        std::get<GBuffer>(aovs).Add(sums, rgb, weight, surface, albedo);
    }
}

void Film::Store(Point2i p, const Pixel &pixel) {
    Sum &sum = pixels[Index(p)];
    std::copy(std::begin(pixel.rgb), std::end(pixel.rgb), sum.rgb);
    sum.weight = pixel.weight;
    float *const values = aovValues.data() + Index(p) * aovChannels.size();
    if (const auto *sums = std::get_if<SpectralBuckets::Sums>(&pixel.aovs))
        std::get<SpectralBuckets>(aovs).Write(*sums, values);
    else if (const auto *sums = std::get_if<GBuffer::Sums>(&pixel.aovs))
        std::get<GBuffer>(aovs).Write(*sums, values);
}

RGB Film::PixelRGB(Point2i p) const {
    const Sum &pixel = pixels[Index(p)];
    if (pixel.weight == 0) return {};
    return {float(pixel.rgb[0] / pixel.weight), float(pixel.rgb[1] / pixel.weight),
            float(pixel.rgb[2] / pixel.weight)};
}

Image Film::ToImage() const {
    std::vector<std::string> channels{"R", "G", "B"};
    channels.insert(channels.end(), aovChannels.begin(), aovChannels.end());
    const int n = int(aovChannels.size());
    Image image({bounds.Width(), bounds.Height()}, std::move(channels));
    for (int y = bounds.y0; y < bounds.y1; ++y)
        for (int x = bounds.x0; x < bounds.x1; ++x) {
            const Point2i at{x - bounds.x0, y - bounds.y0};
            const RGB rgb = PixelRGB({x, y});
            for (int c = 0; c < 3; ++c)
                image.Set(at, c, rgb[c]);
            const float *const values = aovValues.data() + Index({x, y}) * size_t(n);
            for (int c = 0; c < n; ++c)
                image.Set(at, 3 + c, values[c]);
        }
    image.metadata.pixelBounds = {bounds.x0, bounds.x1, bounds.y0, bounds.y1};
    image.metadata.fullResolution = fullResolution;
    if (colorSpace != &RGBColorSpace::sRGB())
        image.metadata.chromaticities = colorSpace->Chromaticities();
    if (std::holds_alternative<SpectralBuckets>(aovs))
        image.metadata.strings = {{"spectralLayoutVersion", "1.0"},
                                  {"emissiveUnits", "W.m^-2.sr^-1"}};
    return image;
}

}  // namespace pbrt
