#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "pbrt/shapes/bilinear_mesh.h"
#include "pbrt/util/atan2.h"
#include "pbrt/util/math.h"

namespace pbrt {

/// The rectangle [x0, x1] x [y0, y1] at height h > 0 over the origin, as seen from there. Sampled
/// by solid angle as in Urena, Fajardo, King 2013, with own closed forms: with c(x) = x /
/// hypot(x, h) and b_j = c(y_j) the solid angle up to x is G(x) - G(x0), G = asin(c b1) -
/// asin(c b0); its inverse is c = sin G / sqrt(b0^2 + b1^2 - 2 b0 b1 cos G).
/// T: float or FloatX16.
template <AnyFloat T>
struct SeenRectangle {
    T x0, x1, y0, y1, h;
    T g0, solidAngle;

    SeenRectangle(T x0, T x1, T y0, T y1, T h)
        : x0(x0), x1(x1), y0(y0), y1(y1), h(h), g0(G(x0)), solidAngle(G(x1) - g0) {}

    Vec2<T> Sample(Vec2<T> u) const {
        const T b0 = y0 / Sqrt(T(y0 * y0 + h * h)), b1 = y1 / Sqrt(T(y1 * y1 + h * h));
        const SinCosT<T> half = SinCosTurns(T((u.x * solidAngle + g0) * (InvPi / 4)));
        const T square = Sqr(b1 - b0) + 4 * b0 * b1 * Sqr(half.sin);
        const T c = Clamp(2 * half.sin * half.cos / SafeSqrt(square), -1.f, 1.f);
        const T x = Min(Max(c * h / SafeSqrt(1 - c * c), x0), x1);
        // On the line of this x the density of s = y / distance is constant.
        const T d2 = x * x + h * h;
        const T s0 = y0 / Sqrt(T(d2 + y0 * y0)), s1 = y1 / Sqrt(T(d2 + y1 * y1));
        const T s = Lerp(u.y, s0, s1);
        return {x, Min(Max(s * Sqrt(d2 / Max(1 - s * s, 1e-12f)), y0), y1)};
    }

  private:
    T G(T x) const {
        const T d2 = x * x + h * h;
        const T hr0 = h * Sqrt(T(d2 + y0 * y0)), hr1 = h * Sqrt(T(d2 + y1 * y1));
        return FastAtan2(T(x * (y1 * hr0 - y0 * hr1)), T(hr0 * hr1 + x * x * y0 * y1));
    }
};

/// A flat rectangular emitter with everything that does not depend on the receiver worked out.
///
/// Directions are drawn by solid angle where the rectangle looks large (more than about 0.25 sr) or
/// reaches from near to far, else by area: there the density per solid angle varies little, and
/// costs a fourth. T: float, or FloatX16 for sixteen rectangles.
template <AnyFloat T>
class RectangleT {
  public:
    struct Sample {
        Vec3<T> p;
        Vec2<T> uv;
        T pdf;  ///< per unit solid angle; 0 where the rectangle is seen edge-on
    };

    /// Sixteen rectangles, often all the same.
    static RectangleT Of(const std::array<const RectangleT<float> *, kPacketSize> &r) {
        RectangleT wide;
        const bool same = std::equal(r.begin() + 1, r.end(), r.begin());
        wide.ForEachMember([&](auto &member, auto of) {
            if (same)
                member = Broadcast<16>(of(*r[0]));
            else
                for (int i = 0; i < kPacketSize; ++i)
                    SetLane(&member, i, of(*r[size_t(i)]));
        });
        return wide;
    }
    /// From a mesh of one rectangular, flat patch.
    static std::optional<RectangleT> From(const BilinearMesh &mesh) {
        if (mesh.NPrimitives() != 1 || !mesh.planar || !mesh.n.empty() || !mesh.uv.empty())
            return {};
        auto r = From(GetPatch(mesh, 0));
        if (r && mesh.flipNormal) r->n = -r->n;
        return r;
    }
    /// From a patch that is a rectangle up to 1e-5 of its sides.
    static std::optional<RectangleT> From(const Patch &patch) {
        const Vector3f e1 = patch.p10 - patch.p00, e2 = patch.p01 - patch.p00;
        const float w2 = LengthSquared(e1), h2 = LengthSquared(e2);
        const Vector3f skew = patch.p11 - patch.p10 - e2;
        if (!(w2 > 0 && h2 > 0) || LengthSquared(skew) > 1e-10f * std::min(w2, h2) ||
            Sqr(Dot(e1, e2)) > 1e-10f * w2 * h2)
            return {};
        RectangleT r;
        r.corner = patch.p00;
        r.width = std::sqrt(w2), r.height = std::sqrt(h2);
        r.x = e1 * (1 / r.width), r.y = e2 * (1 / r.height);
        r.n = Normalize(Cross(r.x, r.y));
        r.pError = Gamma(8) * (Abs(r.corner) + Abs(e1) + Abs(e2));
        return r;
    }

    Vec3<T> Normal() const { return n; }
    /// Bounds of the rounding error of the points drawn, per axis.
    Vec3<T> Error() const { return pError; }

    Sample SampleFrom(Vec3<T> ref, Vec2<T> u) const {
        const View v(*this, ref);
        MaskFor<T> bySolidAngle = v.LooksLarge(*this);
        Vec2<T> q{u.x * width, u.y * height};
        T pdf{};
        if (Any(bySolidAngle)) {
            const SeenRectangle<T> seen = v.Seen(*this);
            bySolidAngle = bySolidAngle & (seen.solidAngle > kLeastSolidAngle);
            const Vec2<T> drawn = seen.Sample(u);
            q = Select(bySolidAngle, Vec2<T>{drawn.x - v.x0, drawn.y - v.y0}, q);
            pdf = 1 / seen.solidAngle;
        }
        if (!All(bySolidAngle)) {
            const T d2 = Sqr(v.x0 + q.x) + Sqr(v.y0 + q.y) + Sqr(v.h);
            pdf = Select(bySolidAngle, pdf, ByArea(v, d2));
        }
        return {corner + q.x * x + q.y * y, {q.x / width, q.y / height}, Select(v.h > 0, pdf, T{})};
    }
    /// Density of SampleFrom for the point p of the rectangle.
    T PDFFrom(Vec3<T> ref, Vec3<T> p) const {
        const View v(*this, ref);
        MaskFor<T> bySolidAngle = v.LooksLarge(*this);
        T pdf{};
        if (Any(bySolidAngle)) {
            const SeenRectangle<T> seen = v.Seen(*this);
            bySolidAngle = bySolidAngle & (seen.solidAngle > kLeastSolidAngle);
            pdf = 1 / seen.solidAngle;
        }
        if (!All(bySolidAngle)) pdf = Select(bySolidAngle, pdf, ByArea(v, LengthSquared(p - ref)));
        return Select(v.h > 0, pdf, T{});
    }

  private:
    template <AnyFloat>
    friend class RectangleT;
    /// Thin strips: the solid angle's absolute error of 2e-7 must not show.
    static constexpr float kLeastSolidAngle = 0.01f;

    /// The rectangle is [x0, x0 + width] x [y0, y0 + height] at height h over the receiver.
    struct View {
        T x0, y0, h;
        View(const RectangleT &r, Vec3<T> ref) {
            const Vec3<T> d = r.corner - ref;
            x0 = Dot(d, r.x), y0 = Dot(d, r.y), h = AbsDot(d, r.n);
        }
        MaskFor<T> LooksLarge(const RectangleT &r) const {
            // Area times cosine over squared distance of the middle: about the solid angle.
            const T d2 = Sqr(x0 + r.width / 2) + Sqr(y0 + r.height / 2) + Sqr(h);
            const T most = 0.25f * d2;
            const MaskFor<T> wide = Sqr(r.width * r.height * h) >= most * most * d2,
                             near = Sqr(r.width) + Sqr(r.height) >= d2;
            return wide | near;
        }
        SeenRectangle<T> Seen(const RectangleT &r) const {
            return {x0, x0 + r.width, y0, y0 + r.height, h};
        }
    };
    /// Density of points drawn by area, d2 being the squared distance.
    T ByArea(const View &v, T d2) const { return d2 * Sqrt(d2) / (v.h * width * height); }

    /// f(member, function that gives the same member of a single rectangle)
    template <typename F>
    void ForEachMember(F f) {
        using One = RectangleT<float>;
        f(corner, [](const One &r) { return r.corner; });
        f(x, [](const One &r) { return r.x; });
        f(y, [](const One &r) { return r.y; });
        f(pError, [](const One &r) { return r.pError; });
        f(n, [](const One &r) { return r.n; });
        f(width, [](const One &r) { return r.width; });
        f(height, [](const One &r) { return r.height; });
    }

    Vec3<T> corner, x, y, pError;
    Vec3<T> n;
    T width{}, height{};
};
using Rectangle = RectangleT<float>;

}  // namespace pbrt
