#include "pbrt/bxdfs/coat.h"

#include <algorithm>
#include <cmath>

#include "pbrt/bxdfs/fresnel.h"
#include "pbrt/bxdfs/microfacet.h"

namespace pbrt {
namespace {

constexpr int kTexturedColumns = 20, kTurnedColumns = 12;

/// Integral of 2 mu f(mu) over mu from 0 to 1 by midpoints; f may begin or end like a root at
/// mu^2 = `kink` and at 0.
template <typename F>
double OverCosines(double kink, int n, const F &f) {
    double below = 0, above = 0;
    for (int i = 0; i < n; ++i) {
        const double q = (i + 0.5) / n;
        below += 2 * q * f(std::max(1e-6f, float(std::sqrt(kink * q * q))));
        above += 2 * q * f(float(std::sqrt(kink + (1 - kink) * q * q)));
    }
    return (kink * below + (1 - kink) * above) / n;
}

}  // namespace

/// A rough boundary as light meets it whose plane of incidence is turned by `phi` from x.
class Coat::Boundary {
  public:
    Boundary(const Coat &coat, float alphaX, float alphaY, float phi)
        : eta(coat.eta),
          depth(coat.depth),
          facets(alphaX, alphaY),
          cosPhi(std::cos(phi)),
          sinPhi(std::sin(phi)),
          nAzimuths(alphaX == alphaY ? kAzimuths / 2 : kAzimuths) {}

    Split From(float cosTheta) const {
        const Vector3f w = Direction(cosTheta);
        double back = 0;
        const double down = OverVisibleNormals(w, [&](Vector3f m) -> double {
            const float cos_o = std::min(1.f, Dot(w, m)), cos_t = CosTransmitted(cos_o, eta);
            const auto [R, T] = FrDielectric(cos_o, cos_t, eta);
            const Vector3f up = Reflect(w, m), in = (cos_o / eta - cos_t) * m - w / eta;
            if (up.z > 0) back += R * Unshadowed(w, up);
            return in.z < 0 ? T * Unshadowed(w, in) * std::exp(depth / in.z) : 0;
        });
        return {float(down), float(back / (nAzimuths * kHeights))};
    }
    /// Share of a diffuse base's light that comes back to it, of what leaves in this plane.
    double Returned() const {
        return OverCosines(1 - 1 / Sqr(double(eta)), 64, [&](float cosTheta) {
            const Vector3f w = Direction(cosTheta);
            const double back = OverVisibleNormals(w, [&](Vector3f m) -> double {
                const Vector3f down = Reflect(w, m);
                if (down.z <= 0) return 0;
                return FrDielectric(std::min(1.f, Dot(w, m)), 1 / eta).R * Unshadowed(w, down) *
                       std::exp(-depth / down.z);
            });
            return back * std::exp(-depth / cosTheta);
        });
    }

  private:
    static constexpr int kAzimuths = 24, kHeights = 40;

    Vector3f Direction(float cosTheta) const {
        const float c = std::max(cosTheta, 1e-6f), s = SafeSqrt(1 - Sqr(c));
        return {s * cosPhi, s * sinPhi, c};
    }
    /// Mean of f(m) over the normals visible from w. Of isotropic facets half of them, the others
    /// being their mirror images.
    template <typename F>
    double OverVisibleNormals(Vector3f w, const F &f) const {
        double sum = 0;
        for (int i = 0; i < nAzimuths; ++i)
            for (int j = 0; j < kHeights; ++j)
                sum += f(facets.SampleVisibleNormal(
                    w, {(float(i) + 0.5f) / kAzimuths, (float(j) + 0.5f) / kHeights}));
        return sum / (nAzimuths * kHeights);
    }
    /// Light that leaves along wi, of what comes to a facet from w; single scattering.
    double Unshadowed(Vector3f w, Vector3f wi) const {
        return facets.GOverCosines(w, wi) * std::abs(wi.z) / facets.G1OverCosine(w);
    }

    float eta, depth;
    TrowbridgeReitz facets;
    float cosPhi, sinPhi;
    int nAzimuths;
};

Coat::Coat(float eta, float depth, float alphaX, float alphaY) : Coat(eta, depth) {
    smoothMean = SmoothMean();
    if (eta == 1) smoothBelow = Infinity;  // no boundary, so no facets either
    if (std::max(alphaX, alphaY) < smoothBelow) return;
    smoothBelow = 0;
    if (alphaX == alphaY) {
        SetColumns(alphaX, alphaX, 1);
        const Boundary boundary(*this, alphaX, alphaX, 0);
        AddColumn(boundary);
        means.push_back(MeanOver(boundary, alphaX));
        return;
    }
    // Each width between the two is that of one azimuth.
    SetColumns(std::min(alphaX, alphaY), std::max(alphaX, alphaY), kTurnedColumns);
    for (int k = 0; k < nColumns; ++k) {
        const float sin2 = (Sqr(AlphaOf(k)) - Sqr(alphaX)) / (Sqr(alphaY) - Sqr(alphaX));
        AddColumn(Boundary(*this, alphaX, alphaY, std::asin(SafeSqrt(std::min(sin2, 1.f)))));
    }
    Averages mean{};
    for (int i = 0; i < kTurnedColumns; ++i) {
        const float phi = (float(i) + 0.5f) * (Pi / 2 / kTurnedColumns);
        const float alpha = std::hypot(alphaX * std::cos(phi), alphaY * std::sin(phi));
        const Averages one = MeanOver(Boundary(*this, alphaX, alphaY, phi), alpha);
        mean.down += one.down / kTurnedColumns, mean.returned += one.returned / kTurnedColumns;
    }
    means.assign(size_t(nColumns), mean);
}

Coat Coat::ForTextures(float eta, float depth) {
    Coat coat(eta, depth);
    coat.smoothMean = coat.SmoothMean();
    if (eta == 1) {
        coat.smoothBelow = Infinity;
        return coat;
    }
    coat.SetColumns(kSmooth, kRoughest, kTexturedColumns);
    const auto boundary = [&](int column) {
        return Boundary(coat, coat.AlphaOf(column), coat.AlphaOf(column), 0);
    };
    for (int k = 0; k < coat.nColumns; ++k)
        coat.AddColumn(boundary(k));
    for (int k = 0; k < coat.nColumns; ++k)
        coat.means.push_back(coat.MeanOver(boundary(k), coat.AlphaOf(k)));
    return coat;
}

void Coat::SetColumns(float alphaMin, float alphaMax, int n) {
    nColumns = n;
    rootMin = std::sqrt(alphaMin);
    rootStep = n > 1 ? (std::sqrt(alphaMax) - rootMin) / float(n - 1) : 1;
}

void Coat::AddColumn(const Boundary &boundary) {
    for (int i = 0; i < kCosines; ++i)
        shares.push_back(boundary.From(Sqr(float(i) / (kCosines - 1))));
}

Coat::Averages Coat::MeanOver(const Boundary &boundary, float alpha) const {
    const double down = OverCosines(0, 256, [&](float c) { return From(c, alpha).down; });
    return {float(down), float(boundary.Returned())};
}

Coat::Averages Coat::SmoothMean() const {
    const double down = OverCosines(0, 256, [&](float c) { return Smooth(c).down; });
    const double returned = OverCosines(1 - 1 / Sqr(double(eta)), 256, [&](float c) {
        return FrDielectric(c, 1 / eta).R * std::exp(-2 * double(depth) / c);
    });
    return {float(down), float(returned)};
}

}  // namespace pbrt
