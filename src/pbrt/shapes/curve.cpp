#include "pbrt/shapes/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 3> kTypes{"flat", "cylinder", "ribbon"};
constexpr std::array<std::string_view, 2> kBases{"bezier", "bspline"};

constexpr ChoiceParam kType{"type", kTypes[0], kTypes,
                            "flat and cylinder turn to the ray; ribbons lie as N says"};
constexpr ChoiceParam kBasis{"basis", kBases[0], kBases, "what the control points are of"};
constexpr IntParam kDegree{"degree", 3, 2, 3, "of the polynomials"};
constexpr IntParam kSplitDepth{"splitdepth", 3, 0, 10,
                               "no effect: the ray tracer splits as it sees fit"};
constexpr ArrayParam kP{"P", "point3", "an error", "control points"};
constexpr ArrayParam kN{"N", "normal", "none",
                        "ribbons only: normals where the segments begin and end"};
constexpr FloatParam kWidth{"width", "", 1, 0, kOpen, "of the curve"};
constexpr FloatParam kWidth0{"width0", "", 1, 0, kOpen, "width of the beginning; not given: width"};
constexpr FloatParam kWidth1{"width1", "", 1, 0, kOpen, "width of the end; not given: width"};

constexpr int kRibbonSteps = 16;  ///< a segment

/// Control points of one cubic Bezier segment.
using Cubic = std::array<Point3f, 4>;

Cubic Elevate(Point3f a, Point3f b, Point3f c) {
    return {a, (a + 2.f * b) / 3.f, (2.f * b + c) / 3.f, c};
}

Cubic FromBSpline(const Point3f *p, int degree) {
    if (degree == 2) return Elevate((p[0] + p[1]) / 2.f, p[1], (p[1] + p[2]) / 2.f);
    return {(p[0] + 4.f * p[1] + p[2]) / 6.f, (2.f * p[1] + p[2]) / 3.f, (p[1] + 2.f * p[2]) / 3.f,
            (p[1] + 4.f * p[2] + p[3]) / 6.f};
}

/// Unit vectors on the great circle from a to b.
Normal3f Slerp(float t, Normal3f a, Normal3f b) {
    const float cosine = std::clamp(Dot(a, b), -1.f, 1.f);
    const Vector3f beside = b - cosine * a;
    if (LengthSquared(beside) < 1e-12f) return a;
    const float angle = t * std::acos(cosine);
    return std::cos(angle) * a + std::sin(angle) * Normalize(beside);
}

/// The factor of a map that keeps shapes, within 1e-3; else 0.
float Similarity(const Transform &t) {
    const Matrix4 &m = t.Matrix();
    if (m[3] != std::array<float, 4>{0, 0, 0, 1}) return 0;
    std::array<Vector3f, 3> axis;
    for (int i = 0; i < 3; ++i)
        axis[i] = {m[0][i], m[1][i], m[2][i]};
    const float scale = Length(axis[0]);
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            const float off = Dot(axis[i], axis[j]) - (i == j ? scale * scale : 0);
            if (!(std::abs(off) <= 2e-3f * scale * scale)) return 0;
        }
    return scale;
}

class CurveReader {
  public:
    explicit CurveReader(const ShapeArguments &a) : a(a), params(a.params) {}

    std::optional<std::variant<CurveSet, TriangleMesh>> Read() {
        const int type = params.GetOneChoice(kType);
        const bool isBezier = params.GetOneChoice(kBasis) == 0;
        const int degree = params.GetOneInt(kDegree);
        params.GetOneInt(kSplitDepth);
        const std::vector<Point3f> p = params.GetPoint3fArray(kP);
        const auto segments = CountSegments(p.size(), isBezier, degree);
        ReadWidths();
        const std::vector<Normal3f> n = params.GetNormalArray(kN);
        if (!segments || !NormalsFit(type, n, *segments) || !TransformFits()) return {};
        for (size_t i = 0; i < *segments; ++i) {
            const Point3f *const q = &p[isBezier ? i * size_t(degree) : i];
            AddSegment(!isBezier     ? FromBSpline(q, degree)
                       : degree == 2 ? Elevate(q[0], q[1], q[2])
                                     : Cubic{q[0], q[1], q[2], q[3]},
                       i, *segments);
        }
        if (kTypes[size_t(type)] == "ribbon") return Ribbon(n);
        curves.type = CurveType(type);
        curves.flipNormal = a.entity.reverseOrientation;
        curves.mirrored = IsMirrored();
        return std::move(curves);
    }

  private:
    std::optional<size_t> CountSegments(size_t points, bool isBezier, int degree) {
        const size_t d = size_t(degree);
        if (points == 0 && params.IsNamed(kP.name)) return {};  // wrong, and reported
        if (points == 0) {
            params.Error(fmt::format("{} needs \"point3 P\"", params.What()));
            return {};
        }
        if (points > d && (!isBezier || (points - 1) % d == 0)) {
            const size_t segments = isBezier ? (points - 1) / d : points - d;
            if (segments <= kMaxCurveSegments) return segments;
            params.Error(kP.name, fmt::format("{} segments; one curve has at most {}", segments,
                                              kMaxCurveSegments));
            return {};
        }
        params.Error(kP.name, isBezier
                                  ? fmt::format("\"point3 P\": {} points; a bezier curve of "
                                                "degree {} has {}, {}, {}... of them",
                                                points, d, d + 1, 2 * d + 1, 3 * d + 1)
                                  : fmt::format("\"point3 P\": {} points; a bspline of degree {} "
                                                "has {} or more of them",
                                                points, d, d + 1));
        return {};
    }

    void ReadWidths() {
        FloatParam begin = kWidth0, end = kWidth1;
        begin.def = end.def = params.GetOneFloat(kWidth);
        width = {params.GetOneFloat(begin), params.GetOneFloat(end)};
    }

    bool NormalsFit(int type, const std::vector<Normal3f> &n, size_t segments) {
        if (kTypes[size_t(type)] != "ribbon") {
            if (!n.empty()) params.Warning(kN.name, "\"normal N\": only ribbons have normals");
            return true;
        }
        const bool fit =
            n.size() == segments + 1 && std::all_of(n.begin(), n.end(), [](Normal3f v) {
                return LengthSquared(v) > 0 && LengthSquared(v) < Infinity;
            });
        if (!fit)
            params.Error(n.empty() ? kType.name : kN.name,
                         fmt::format("\"normal N\": a ribbon of {} segment{} needs {} normals, not "
                                     "0 in length; {} given",
                                     segments, segments == 1 ? "" : "s", segments + 1, n.size()));
        return fit;
    }

    bool TransformFits() {
        scale = Similarity(a.renderFromObject);
        if (scale > 0) return true;
        params.Error(
            fmt::format("{} is stretched unevenly by its transformation; only turning, "
                        "moving and even scaling keep its width",
                        params.What()));
        return false;
    }

    void AddSegment(const Cubic &cubic, size_t index, size_t segments) {
        if (index == 0) AddPoint(cubic[0], 0);
        curves.first.push_back(uint32_t(curves.points.size() - 1));
        for (int k = 1; k < 4; ++k)
            AddPoint(cubic[size_t(k)], (float(index) + float(k) / 3) / float(segments));
    }
    /// The width is linear along the whole curve, and Bezier curves keep what is linear.
    void AddPoint(Point3f p, float along) {
        curves.points.push_back(
            {a.renderFromObject.Point(p), scale * Lerp(along, width[0], width[1]) / 2});
    }

    /// As triangles: accel/native.cpp says why. The corners of both ends of a segment are its own:
    /// u starts anew on each.
    TriangleMesh Ribbon(const std::vector<Normal3f> &n) const {
        TriangleMesh mesh;
        for (size_t i = 0; i < curves.first.size(); ++i) {
            const Normal3f from = Normalize(a.renderFromObject.Normal(n[i]));
            const Normal3f to = Normalize(a.renderFromObject.Normal(n[i + 1]));
            for (int k = 0; k <= kRibbonSteps; ++k) {
                const float u = float(k) / kRibbonSteps;
                const CurveAt at(&curves.points[curves.first[i]], u);
                const Vector3f right = UnitCross(Slerp(u, from, to), at.dpdu);
                const Vector3f side = IsMirrored() ? -right : right;
                for (float v : {0.f, 1.f}) {
                    mesh.p.push_back(at.p + (2 * v - 1) * at.radius * side);
                    mesh.n.push_back((IsFlipped() ? -1.f : 1.f) * UnitCross(at.dpdu, side));
                    mesh.uv.push_back({u, 1 - v});
                }
                const uint32_t last = uint32_t(mesh.p.size());
                for (uint32_t back : {4, 2, 1, 4, 1, 3})
                    if (k > 0) mesh.indices.push_back(last - back);
            }
        }
        mesh.p.reserve(mesh.p.size() + kPointsBehindLast);
        mesh.flipNormal = IsFlipped();
        return mesh;
    }

    bool IsMirrored() const { return a.renderFromObject.SwapsHandedness(); }
    bool IsFlipped() const { return a.entity.reverseOrientation != IsMirrored(); }

    const ShapeArguments &a;
    ParamDict &params;
    CurveSet curves;
    std::array<float, 2> width{};
    float scale = 1;
};

}  // namespace

Bounds3f CurveSet::BoundsOf(const CurvePoint *c, size_t count) {
    Bounds3f b;
    for (size_t i = 0; i < count; ++i) {
        const Vector3f r{c[i].radius, c[i].radius, c[i].radius};
        b.Grow(c[i].p - r);
        b.Grow(c[i].p + r);
    }
    return b;
}

bool Append(const CurveSet &more, CurveSet *into) {
    const size_t before = into->points.size();
    if (more.type != into->type || more.flipNormal != into->flipNormal ||
        more.mirrored != into->mirrored ||
        into->first.size() + more.first.size() > kMaxCurveSegments)
        return false;
    for (const uint32_t first : more.first)
        into->first.push_back(uint32_t(before) + first);
    into->points.insert(into->points.end(), more.points.begin(), more.points.end());
    return true;
}

std::optional<std::variant<CurveSet, TriangleMesh>> CurveSet::Create(const ShapeArguments &a) {
    return CurveReader(a).Read();
}

}  // namespace pbrt
