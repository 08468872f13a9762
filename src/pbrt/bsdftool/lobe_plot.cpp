#include "pbrt/bsdftool/lobe_plot.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "pbrt/bsdftool/energy.h"
#include "pbrt/bsdftool/spectral_bsdf.h"

namespace pbrt::bsdftool {
namespace {

const std::vector<std::string> kRGB{"R", "G", "B"};

/// f at all wavelengths for many directions.
template <typename B>
class Scatterer {
  public:
    Scatterer(const SpectralBSDF<B> &spectral, Vector3f wo, const ScatterogramOptions &options,
              const Observer &observer)
        : spectral(spectral), wo(wo), options(options), observer(observer) {}

    /// The disc of the side where z has the sign of `side`.
    Image Disc(float side) const {
        const int n = options.resolution;
        Image image({n, n}, kRGB);
        tbb::parallel_for(0, n, [&](int y) {
            std::vector<float> values(size_t(options.wavelengths));
            for (int x = 0; x < n; ++x) {
                const RGB rgb = PixelColor(x, y, side, values);
                for (int c = 0; c < 3; ++c)
                    image.Set({x, y}, c, rgb[c]);
            }
        });
        return image;
    }

  private:
    /// The mean over the part of the pixel inside the disc.
    RGB PixelColor(int px, int py, float side, std::vector<float> &values) const {
        const int s = options.subpixels;
        const float step = 2 / float(options.resolution * s);
        RGB sum;
        int inside = 0;
        for (int sy = 0; sy < s; ++sy)
            for (int sx = 0; sx < s; ++sx) {
                // From the middle, so that mirrored pixels are mirrored to the last bit.
                const float x = (float(px * s + sx) + 0.5f - 0.5f * float(options.resolution * s));
                const float y = (0.5f * float(options.resolution * s) - 0.5f - float(py * s + sy));
                const Vector3f flat{x * step, y * step, 0};
                const float zSqr = 1 - LengthSquared(flat);
                if (!(zSqr > 0)) continue;
                ++inside;
                sum = sum + ColorTowards({flat.x, flat.y, side * std::sqrt(zSqr)}, values);
            }
        return inside > 0 ? sum * (1 / float(inside)) : sum;
    }

    RGB ColorTowards(Vector3f wi, std::vector<float> &values) const {
        const float scale = options.timesCosine ? std::abs(wi.z) : 1;
        bool black = true;
        for (const auto &part : spectral.parts) {
            const SampledSpectrum f = part.bsdf.f(wo, wi, TransportMode::Importance);
            for (size_t k = 0; k < part.count; ++k)
                values[part.first + k] = f[int(k)] * scale;
            black = black && !f;
        }
        return black ? RGB() : observer.ToRGB(values);
    }

    const SpectralBSDF<B> &spectral;
    Vector3f wo;
    const ScatterogramOptions &options;
    const Observer &observer;
};

}  // namespace

LobePlot ScatterLight(const Material &material, const LightAngles &light,
                      const ScatterogramOptions &options, const Spectrum &illuminant) {
    const std::vector<float> lambda = MiddleWavelengths(options.wavelengths);
    const Observer observer(lambda, illuminant);
    const Vector3f wo = Spherical(light.theta, light.phi).ToFloat();
    LobePlot view;
    view.light = light;
    WithSpectralBSDF(material, lambda, [&]<typename B>(const SpectralBSDF<B> &spectral) {
        const Scatterer scatterer(spectral, wo, options, observer);
        const float side = std::copysign(1.f, wo.z);
        view.ownSide = scatterer.Disc(side);
        view.otherSide = scatterer.Disc(-side);
        if constexpr (kIsFeather<B>) {
            view.hasGap = true;
            view.gap = spectral.parts[0].bsdf.GapFraction(wo);
        }
    });
    return view;
}

Image Montage(const std::vector<LobePlot> &views) {
    const int n = views.empty() ? 0 : views[0].ownSide.Resolution().x;
    Image all({2 * n, n * int(views.size())}, kRGB);
    for (size_t i = 0; i < views.size(); ++i)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < 2 * n; ++x) {
                const Image &side = x < n ? views[i].ownSide : views[i].otherSide;
                for (int c = 0; c < 3; ++c)
                    all.Set({x, y + int(i) * n}, c, side.Get({x % n, y}, c));
            }
    all.metadata.chromaticities = RGBColorSpace::sRGB().Chromaticities();
    return all;
}

float AutomaticExposure(const std::vector<LobePlot> &views) {
    std::vector<float> values;
    for (const LobePlot &view : views)
        for (const Image *image : {&view.ownSide, &view.otherSide})
            for (size_t i = 0; i < image->Data().size(); i += 3) {
                const float *rgb = &image->Data()[i];
                const float most = std::max({rgb[0], rgb[1], rgb[2]});
                if (most > 0) values.push_back(most);
            }
    if (values.empty()) return 1;
    const auto place = values.begin() + std::ptrdiff_t(0.99 * double(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return 1 / *place;
}

}  // namespace pbrt::bsdftool
