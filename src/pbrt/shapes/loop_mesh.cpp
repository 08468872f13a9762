#include "pbrt/shapes/loop_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pbrt/util/math.h"

namespace pbrt {
namespace {

/// Weight of each of n neighbours of a vertex inside the mesh.
double NeighbourWeight(size_t n) {
    return n == 3 ? 3. / 16 : 3. / (8 * double(n));
}
/// The same in the limit: of the left eigenvector of the step's matrix, whose eigenvalue is 1.
double LimitWeight(size_t n) {
    return 1 / (double(n) + 3 / (8 * NeighbourWeight(n)));
}

Vector3d Sum(const std::vector<Vector3d> &points) {
    Vector3d sum{0, 0, 0};
    for (const Vector3d &p : points)
        sum = sum + p;
    return sum;
}
/// The point with the rest of 1 as its weight, each of the others with `weight`.
Vector3d Weighted(Vector3d p, const std::vector<Vector3d> &others, double weight) {
    return (1 - double(others.size()) * weight) * p + weight * Sum(others);
}

/// Directions in which the limit is left from a vertex, from the eigenvectors that follow the
/// first.
struct Tangents {
    Vector3d s, t;
};
Tangents Inside(const std::vector<Vector3d> &ring) {
    Tangents d{{0, 0, 0}, {0, 0, 0}};
    for (size_t i = 0; i < ring.size(); ++i) {
        const double turn = 2 * M_PI * double(i) / double(ring.size());
        d.s = d.s + std::cos(turn) * ring[i];
        d.t = d.t + std::sin(turn) * ring[i];
    }
    return d;
}
/// Along the boundary, and across it, outwards. Across: the left eigenvector of the step's matrix
/// that is symmetric, with weights w of the vertex, a of either end of the ring, sin(i theta)
/// between, theta = pi / (n - 1), and the eigenvalue 3/8 + cos(theta) / 4. Its two equations for w
/// and a, that of an end and that of the vertex, are solved below.
Tangents OnBoundary(Vector3d p, const std::vector<Vector3d> &ring) {
    const Vector3d along = ring.back() - ring.front(), ends = ring.front() + ring.back();
    if (ring.size() == 2) return {along, 2. * p - ends};
    const double theta = M_PI / double(ring.size() - 1);
    const double value = 3. / 8 + std::cos(theta) / 4, sumOfSines = 1 / std::tan(theta / 2);
    const double a = (3. / 8 * sumOfSines + (value - 3. / 4) * std::sin(theta)) /
                     (8 * (value - 3. / 4) * (value - 1. / 2) - 1);
    const double w = 8 * (value - 1. / 2) * a - std::sin(theta);
    Vector3d inwards = a * ends + w * p;
    for (size_t i = 1; i + 1 < ring.size(); ++i)
        inwards += std::sin(double(i) * theta) * ring[i];
    return {along, -inwards};
}

}  // namespace

LoopMesh::LoopMesh(const std::vector<Point3f> &points, const std::vector<uint32_t> &indices)
    : corners(indices) {
    FindTwins();
    SplitVertices(points);
}

void LoopMesh::FindTwins() {
    struct Edge {
        uint32_t lower, upper, h;
    };
    std::vector<Edge> edges(corners.size());
    for (uint32_t h = 0; h < uint32_t(corners.size()); ++h) {
        const auto [lower, upper] = std::minmax(corners[h], corners[Next(h)]);
        edges[h] = {lower, upper, h};
    }
    const auto isSame = [](const Edge &a, const Edge &b) {
        return a.lower == b.lower && a.upper == b.upper;
    };
    std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) {
        return std::tie(a.lower, a.upper, a.h) < std::tie(b.lower, b.upper, b.h);
    });
    twins.assign(corners.size(), kNone);
    for (size_t i = 0, end; i < edges.size(); i = end) {
        for (end = i + 1; end < edges.size() && isSame(edges[i], edges[end]);)
            ++end;
        if (end - i != 2) continue;
        const uint32_t a = edges[i].h, b = edges[i + 1].h;
        if (corners[a] == corners[b]) continue;
        twins[a] = b;
        twins[b] = a;
    }
}

void LoopMesh::SplitVertices(const std::vector<Point3f> &points) {
    std::vector<uint32_t> split(corners.size(), kNone);
    for (uint32_t start = 0; start < uint32_t(corners.size()); ++start) {
        if (split[start] != kNone) continue;
        // Clockwise to the boundary, or all around; from there the other way.
        uint32_t h = start;
        while (twins[h] != kNone && Next(twins[h]) != start)
            h = Next(twins[h]);
        const Point3f p = points[corners[start]];
        positions.push_back({p.x, p.y, p.z});
        first.push_back(h);
        while (h != kNone && split[h] == kNone) {
            split[h] = uint32_t(positions.size() - 1);
            h = twins[Previous(h)];
        }
    }
    corners = std::move(split);
}

LoopMesh::Ring LoopMesh::RingOf(uint32_t vertex) const {
    Ring ring;
    uint32_t h = first[vertex];
    do {
        ring.p.push_back(positions[corners[Next(h)]]);
        const uint32_t last = Previous(h);
        h = twins[last];
        if (h == kNone) ring.p.push_back(positions[corners[last]]);
    } while (h != kNone && h != first[vertex]);
    ring.isClosed = h != kNone;
    return ring;
}

Vector3d LoopMesh::Smoothed(uint32_t vertex) const {
    const Ring ring = RingOf(vertex);
    const Vector3d p = positions[vertex];
    if (ring.isClosed) return Weighted(p, ring.p, NeighbourWeight(ring.p.size()));
    return Weighted(p, {ring.p.front(), ring.p.back()}, 1. / 8);
}

Vector3d LoopMesh::EdgePoint(uint32_t h) const {
    const Vector3d ends = positions[corners[h]] + positions[corners[Next(h)]];
    if (twins[h] == kNone) return 0.5 * ends;
    const Vector3d opposite =
        positions[corners[Previous(h)]] + positions[corners[Previous(twins[h])]];
    return 3. / 8 * ends + 1. / 8 * opposite;
}

LoopMesh LoopMesh::Subdivided() const {
    LoopMesh finer;
    for (uint32_t v = 0; v < uint32_t(positions.size()); ++v)
        finer.positions.push_back(Smoothed(v));
    // Half-edge h = 3 f + i of triangle f becomes two: the first of child i of f, and the last of
    // the next child. The children 4 f + i are (corner i, point on edge i, point on edge i - 1);
    // the fourth one lies between the edges' points.
    const auto head = [](uint32_t h) { return h / 3 * 12 + h % 3 * 3; };
    const auto tail = [](uint32_t h) { return h / 3 * 12 + (h + 1 - h / 3 * 3) % 3 * 3 + 2; };
    std::vector<uint32_t> onEdge(corners.size());
    finer.first.resize(positions.size());
    for (uint32_t v = 0; v < uint32_t(positions.size()); ++v)
        finer.first[v] = head(first[v]);
    for (uint32_t h = 0; h < uint32_t(corners.size()); ++h) {
        if (twins[h] < h) {
            onEdge[h] = onEdge[twins[h]];
            continue;
        }
        onEdge[h] = uint32_t(finer.positions.size());
        finer.positions.push_back(EdgePoint(h));
        finer.first.push_back(tail(h));
    }
    finer.corners.resize(4 * corners.size());
    finer.twins.resize(4 * corners.size());
    for (uint32_t h = 0; h < uint32_t(corners.size()); ++h) {
        const uint32_t child = head(h), middle = h / 3 * 12 + 9;
        const uint32_t before = Previous(h) % 3, t = twins[h];
        finer.corners[child] = corners[h];
        finer.corners[child + 1] = onEdge[h];
        finer.corners[child + 2] = onEdge[Previous(h)];
        finer.corners[middle + h % 3] = onEdge[h];
        finer.twins[child + 1] = middle + before;
        finer.twins[middle + before] = child + 1;
        finer.twins[child] = t == kNone ? kNone : tail(t);
        finer.twins[tail(h)] = t == kNone ? kNone : head(t);
    }
    return finer;
}

Point3f LoopMesh::LimitPosition(uint32_t vertex) const {
    const Ring ring = RingOf(vertex);
    const Vector3d p = positions[vertex];
    if (ring.isClosed) return ToFloat(Weighted(p, ring.p, LimitWeight(ring.p.size())));
    // The B-spline's; pbrt-v4 has 1/5, of Hoppe's other rules.
    return ToFloat(Weighted(p, {ring.p.front(), ring.p.back()}, 1. / 6));
}

Normal3f LoopMesh::LimitNormal(uint32_t vertex) const {
    const Ring ring = RingOf(vertex);
    const Tangents d = ring.isClosed ? Inside(ring.p) : OnBoundary(positions[vertex], ring.p);
    const Vector3d n = Cross(d.s, d.t);
    const double length = Length(n);
    return length > 0 ? ToFloat(n * (1 / length)) : Normal3f{0, 0, 0};
}

}  // namespace pbrt
