#pragma once

#include "pbrt/util/sampling.h"

namespace pbrt {

/// Microfacets of Trowbridge and Reitz ("GGX"), anisotropic, with Smith's height-correlated
/// shadowing: the statistics of an ellipsoid's normals. Directions may lie on either side; normals
/// m need not be unit but must lie on the upper side.
class TrowbridgeReitz {
  public:
    /// Slopes' widths along x and y, >= 0. Below 1e-4 is raised to it where the other is not
    /// smooth.
    TrowbridgeReitz(float alphaX, float alphaY) : ax(alphaX), ay(alphaY) {
        if (!IsSmooth()) ax = std::max(ax, 1e-4f), ay = std::max(ay, 1e-4f);
    }

    /// So smooth that it is treated as a mirror.
    bool IsSmooth() const { return std::max(ax, ay) < 1e-3f; }

    /// Density of normals per unit solid angle and projected area.
    float D(Vector3f m) const {
        const float ratio = LengthSquared(m) / (Sqr(m.x / ax) + Sqr(m.y / ay) + Sqr(m.z));
        return Sqr(ratio) * InvPi / (ax * ay);
    }
    /// |w.z| (1 + 2 Lambda(w)): Smith's auxiliary function in a form that does not diverge.
    float Slant(Vector3f w) const { return std::sqrt(Sqr(w.z) + Sqr(ax * w.x) + Sqr(ay * w.y)); }
    /// G(wo, wi) / |wo.z wi.z| with the height-correlated masking 1 / (1 + Lambda + Lambda).
    float GOverCosines(Vector3f wo, Vector3f wi) const {
        return 2 / (std::abs(wo.z) * Slant(wi) + std::abs(wi.z) * Slant(wo));
    }
    /// G1(w) / |w.z|: times D(m) |w . m| it is the density of the normals visible from w.
    float G1OverCosine(Vector3f w) const { return 2 / (std::abs(w.z) + Slant(w)); }

    /// A normal visible from w (on w's side of the surface, m . w > 0), with the density above.
    /// Spherical caps: Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps".
    Vector3f SampleVisibleNormal(Vector3f w, Point2f u) const {
        const float side = std::copysign(1.f, w.z);
        // Stretched so that the ellipsoid is a sphere.
        const Vector3f v = Normalize(Vector3f{ax * w.x * side, ay * w.y * side, std::abs(w.z)});
        const float z = (1 - u.y) * (1 + v.z) - v.z;
        const float r = SafeSqrt((1 - z) * (1 + z));
        const SinCos phi = SinCosTurns(u.x);
        const Vector3f h{r * phi.cos + v.x, r * phi.sin + v.y, std::max(z + v.z, 1e-7f)};
        return side * Normalize(Vector3f{ax * h.x, ay * h.y, h.z});
    }

    /// Blurs what is sharp: each width below 0.3 is doubled within [0.1, 0.3].
    void Regularize() {
        if (ax < 0.3f) ax = std::clamp(2 * ax, 0.1f, 0.3f);
        if (ay < 0.3f) ay = std::clamp(2 * ay, 0.1f, 0.3f);
    }

  private:
    float ax, ay;
};

}  // namespace pbrt
