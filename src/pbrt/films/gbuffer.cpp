#include "pbrt/films/gbuffer.h"

#include <cmath>

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 2> kSpaces{"camera", "world"};
constexpr ChoiceParam kCoordinateSystem{"coordinatesystem", kSpaces[0], kSpaces,
                                        "space of positions and normals"};

// Places in Sums::surface.
enum { Albedo = 0, P = 3, Slope = 6, N = 8, Ns = 11, UV = 14 };

}  // namespace

GBuffer GBuffer::Create(ParamDict &params) {
    GBuffer g;
    g.inWorld = params.GetOneChoice(kCoordinateSystem) == 1;
    return g;
}

void GBuffer::Add(Sums *sums, const RGB &rgb, float weight, const VisibleSurface *surface,
                  const RGB &albedo) const {
    // Welford's recurrence: nothing cancels.
    ++sums->n;
    for (int c = 0; c < 3; ++c) {
        const double difference = rgb[c] - sums->mean[c];
        sums->mean[c] += difference / double(sums->n);
        sums->squares[c] += difference * (rgb[c] - sums->mean[c]);
    }
    if (!surface) return;
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
    sums->weight += weight;
    for (size_t i = 0; i < values.size(); ++i)
        sums->surface[i] += double(weight) * values[i];
}

std::vector<std::string> GBuffer::ChannelNames() const {
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

void GBuffer::Write(const Sums &sums, float *channels) const {
    for (size_t i = 0; i < kSurfaceChannels; ++i)
        channels[i] = sums.weight == 0 ? 0 : float(sums.surface[i] / sums.weight);
    for (int first : {N, Ns}) {
        float *const n = channels + first;
        const float length = std::sqrt(Sqr(n[0]) + Sqr(n[1]) + Sqr(n[2]));
        if (length > 0)
            for (int c = 0; c < 3; ++c)
                n[c] /= length;
    }
    float *const variance = channels + kSurfaceChannels, *const relative = variance + 3;
    for (int c = 0; c < 3; ++c) {
        const double v = sums.n < 2 ? 0 : sums.squares[c] / double(sums.n - 1);
        variance[c] = float(v);
        relative[c] = sums.mean[c] == 0 ? 0 : float(v / Sqr(sums.mean[c]));
    }
}

}  // namespace pbrt
