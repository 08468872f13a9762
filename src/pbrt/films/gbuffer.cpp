#include "pbrt/films/gbuffer.h"

#include <algorithm>
#include <cmath>

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 2> kSpaces{"camera", "world"};
constexpr ChoiceParam kCoordinateSystem{"coordinatesystem", kSpaces[0], kSpaces,
                                        "space of positions and normals"};

// Places in Sums::surface.
enum { Albedo = 0, P = 3, Slope = 6, N = 8, Ns = 11, UV = 14 };

}  // namespace

GBufferFilm GBufferFilm::Create(ParamDict &params) {
    GBufferFilm g;
    g.inWorld = params.GetOneChoice(kCoordinateSystem) == 1;
    return g;
}

void GBufferFilm::Add(Sums *sums, const FilmSample &sample) const {
    sums->weightOfAll += sample.weight;
    const VisibleSurface *const surface = sample.surface;
    if (!surface) return;
    sums->n += 1;
    for (int c = 0; c < 3; ++c) {
        sums->rgb[size_t(c)][0] += sample.rgb[c];
        sums->rgb[size_t(c)][1] += Sqr(double(sample.rgb[c]));
    }
    const RGB albedo = sample.albedo;
    const Transform &t = outputFromRender;
    const Point3f p = t.Point(surface->p);
    const Vector3f n = Normalize(t.Normal(surface->n)), ns = Normalize(t.Normal(surface->ns));
    const std::array<float, kSurfaceChannels> values{albedo.r,
                                                     albedo.g,
                                                     albedo.b,
                                                     p.x,
                                                     p.y,
                                                     p.z,
                                                     t.Vector(surface->dpdx).z,
                                                     t.Vector(surface->dpdy).z,
                                                     n.x,
                                                     n.y,
                                                     n.z,
                                                     ns.x,
                                                     ns.y,
                                                     ns.z,
                                                     surface->uv.x,
                                                     surface->uv.y};
    sums->weight += sample.weight;
    for (size_t i = 0; i < values.size(); ++i)
        sums->surface[i] += double(sample.weight) * values[i];
}

std::vector<std::string> GBufferFilm::ChannelNames() const {
    return {"Albedo.R",
            "Albedo.G",
            "Albedo.B",
            "P.X",
            "P.Y",
            "P.Z",
            "dzdx",
            "dzdy",
            "N.X",
            "N.Y",
            "N.Z",
            "Ns.X",
            "Ns.Y",
            "Ns.Z",
            "u",
            "v",
            "Variance.R",
            "Variance.G",
            "Variance.B",
            "RelativeVariance.R",
            "RelativeVariance.G",
            "RelativeVariance.B"};
}

void GBufferFilm::Write(const Sums &sums, float *channels) const {
    const double weight = sums.weight.Value();
    for (size_t i = 0; i < kSurfaceChannels; ++i)
        channels[i] = weight == 0 ? 0 : float(sums.surface[i].Value() / weight);
    const double ofAll = sums.weightOfAll.Value();
    for (int c = Albedo; c < Albedo + 3; ++c)
        channels[c] = ofAll == 0 ? 0 : float(sums.surface[size_t(c)].Value() / ofAll);
    for (int first : {N, Ns}) {
        float *const n = channels + first;
        const float length = std::sqrt(Sqr(n[0]) + Sqr(n[1]) + Sqr(n[2]));
        if (length > 0)
            for (int c = 0; c < 3; ++c)
                n[c] /= length;
    }
    float *const variance = channels + kSurfaceChannels, *const relative = variance + 3;
    for (size_t c = 0; c < 3; ++c) {
        const double n = std::max(sums.n.Value(), 1.);
        const double mean = sums.rgb[c][0].Value() / n;
        // Both sums are exact but for ExactSum's last digit, so that the difference of the two,
        // which cancels for even pixels, errs by n 2^-53 of the squared mean.
        const double squares = std::max(sums.rgb[c][1].Value() - n * mean * mean, 0.);
        const double v = n < 2 ? 0 : squares / (n - 1);
        variance[c] = float(v);
        relative[c] = mean == 0 ? 0 : float(v / mean);
    }
}

}  // namespace pbrt
