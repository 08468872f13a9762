#pragma once

#include "pbrt/shapes/rounding.h"
#include "pbrt/shapes/solid_angle.h"
#include "pbrt/shapes/triangle_mesh.h"
#include "pbrt/util/atan2.h"
#include "pbrt/util/math.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// One triangle of a mesh as an emitter.
class TriangleSampler {
  public:
    TriangleSampler(const TriangleMesh &mesh, uint32_t primitive)
        : mesh(mesh),
          i(&mesh.indices[3 * size_t(primitive)]),
          p0(mesh.p[i[0]]),
          e1(mesh.p[i[1]] - p0),
          e2(mesh.p[i[2]] - p0) {}

    float Area() const { return 0.5f * Length(Cross(e1, e2)); }

    std::optional<ShapeSample> SampleArea(Point2f u) const {
        const float area = Area();
        if (!(area > 0)) return {};
        const Point2f b = SampleUniformTriangle(u);
        return At(1 - b.x - b.y, b.y, 1 / area);
    }

    std::optional<ShapeSample> SampleFrom(Point3f ref, Point2f u) const {
        const Seen seen(*this, ref);
        if (!seen.IsUsed()) return SeenFrom(SampleArea(u), ref);
        const Point2f b = Meet(ref, seen.Sample(u));
        return At(b.x, b.y, 1 / seen.solidAngle);
    }

    float PDFFrom(Point3f ref, Point3f p, Normal3f n) const {
        const Seen seen(*this, ref);
        return seen.IsUsed() ? 1 / seen.solidAngle : PerSolidAngle(1 / Area(), ref, p, n);
    }

    NormalCone Normals() const {
        const int side = Side();
        return {float(side < 0 ? -1 : 1) * Normal(), side == 0 ? -1.f : 1.f};
    }

  private:
    Normal3f Normal() const {
        const Normal3f n = UnitCross(e1, e2);
        return mesh.flipNormal ? -n : n;
    }
    /// 1 or -1: per-vertex normals leave n or turn it over; 0: they disagree.
    int Side() const {
        if (mesh.n.empty()) return 1;
        const Normal3f n = Normal();
        const bool s0 = Dot(n, mesh.n[i[0]]) < 0;
        const bool agree = s0 == (Dot(n, mesh.n[i[1]]) < 0) && s0 == (Dot(n, mesh.n[i[2]]) < 0);
        return agree ? (s0 ? -1 : 1) : 0;
    }

    // With unit vectors a, b, c to the corners, tan(area / 2) = |det(a, b, c)| / (1 + a.b + b.c +
    // c.a) (Van Oosterom, Strackee 1983). A point on the arc from a to c, the mirror image of a in
    // h = x a + y c, cuts off the triangle (a, b, point) with tan = y det / (x (1 + a.b) + y (a +
    // b).c); solving for x : y at the wanted share of the area needs no inverse function. Then Arvo
    // 1995: along the arc from b to the point, 1 - cos(distance from b) is uniform.
    struct Seen {
        Vector3f a, b, c;
        float det, sumC, sumAB, solidAngle;

        Seen(const TriangleSampler &t, Point3f ref)
            : a(Normalize(t.p0 - ref)),
              b(Normalize(t.p0 + t.e1 - ref)),
              c(Normalize(t.p0 + t.e2 - ref)) {
            det = AbsDot(a, Cross(b - a, c - a));
            sumC = Dot(a + b, c);
            sumAB = 1 + Dot(a, b);
            solidAngle = 2 * FastAtan2(det, sumC + sumAB);
        }
        /// Smaller ones suffer from rounding and gain nothing; nearly a half sphere has no clear
        /// corners.
        bool IsUsed() const { return solidAngle > 3e-4f && solidAngle < 6.22f; }

        Vector3f Sample(Point2f u) const {
            const SinCos half = SinCosTurns(u.x * solidAngle * (InvPi / 4));
            const Vector3f h = (det * half.cos - sumC * half.sin) * a + sumAB * half.sin * c;
            const Vector3f end = (2 * Dot(a, h) / LengthSquared(h)) * h - a;
            const Vector3f chord = end - b;
            const float versine = 0.5f * LengthSquared(chord), d = u.y * versine;
            // The tangent at b, chord + versine b, has the squared length versine (2 - versine).
            const float along = SafeSqrt(u.y * (2 - d) / std::max(2 - versine, 1e-6f));
            return (1 - d) * b + along * (chord + versine * b);
        }
    };

    /// Barycentrics of corners 1 and 2 where direction w from ref meets the triangle.
    Point2f Meet(Point3f ref, Vector3f w) const {
        const Vector3f across = Cross(w, e2), s = ref - p0;
        const float inv = 1 / Dot(e1, across);
        const float b1 = std::clamp(Dot(s, across) * inv, 0.f, 1.f);
        const float b2 = std::clamp(Dot(w, Cross(s, e1)) * inv, 0.f, 1.f);
        const float excess = std::max(b1 + b2, 1.f);
        return {b1 / excess, b2 / excess};
    }

    ShapeSample At(float b1, float b2, float pdf) const {
        const float b0 = 1 - b1 - b2;
        const Point3f q0 = b0 * p0, q1 = b1 * mesh.p[i[1]], q2 = b2 * mesh.p[i[2]];
        ShapeSample s;
        s.p = q0 + q1 + q2;
        s.pError = Gamma(8) * (Abs(q0) + Abs(q1) + Abs(q2));
        s.n = Normal();
        if (!mesh.n.empty())
            s.n = FaceForward(s.n, b0 * mesh.n[i[0]] + b1 * mesh.n[i[1]] + b2 * mesh.n[i[2]]);
        s.uv = mesh.uv.empty() ? Point2f{b1 + b2, b2}
                               : b0 * mesh.uv[i[0]] + b1 * mesh.uv[i[1]] + b2 * mesh.uv[i[2]];
        s.pdf = pdf;
        return s;
    }

    const TriangleMesh &mesh;
    const uint32_t *i;
    Point3f p0;
    Vector3f e1, e2;
};

}  // namespace pbrt
