#include "pbrt/feathergen/covering.h"

#include <algorithm>

#include "pbrt/util/rng.h"

namespace pbrt::feathergen {
namespace {

/// A feather's place before it is turned up.
struct Seat {
    SurfaceSample at;
    double size;
    int kind;
    double yaw, roll;
};

double SizeAt(const Parameters &p, double along) {
    return Lerp(along, p.neckSizeTop, p.neckSizeBottom);
}

/// Accepts places in order while they keep the distance to those before (dart throwing).
std::vector<SurfaceSample> Spread(std::span<const SurfaceSample> surface, const Parameters &p) {
    std::vector<SurfaceSample> kept;
    for (const SurfaceSample &s : surface) {
        const double least = p.neckSpacing * SizeAt(p, s.along);
        const bool isFree = std::none_of(kept.begin(), kept.end(), [&](const SurfaceSample &k) {
            return LengthSquared(k.p - s.p) < Sqr(least);
        });
        if (isFree) kept.push_back(s);
        if (kept.size() > kMostFeathers) break;
    }
    return kept;
}

/// Slow waves over the surface, mean 0, about [-1, 1]: so that the border of the colors is no line.
double Waves(Vec3d p, double length) {
    const double a = 7 / length;
    return (std::sin(a * p.x + 1) + std::sin(0.8 * a * p.y + 0.5 * a * p.x + 2) +
            std::sin(1.9 * a * p.y - 0.9 * a * p.z)) /
           2;
}

int ColorAt(const SurfaceSample &s, const Parameters &p, double length, double jitter) {
    const double way = (s.along + 0.05 * Waves(s.p, length) - p.neckBorder) / p.neckBorderWidth;
    const double color = (kNeckColors - 1) * (way + 0.5) + 0.5 + jitter;
    return color > 0 ? int(std::min(color, kNeckColors - 1.)) : 0;
}

Placed Stand(const Seat &seat, Vec3d flow, double pitch) {
    const Vec3d n = seat.at.n;
    Vec3d y = flow - Dot(flow, n) * n;
    if (LengthSquared(y) < 1e-12) y = Cross(n, Vec3d{1, 0.3, 0.2});
    y = Normalize(y);
    Vec3d x = Cross(y, n);
    y = Normalize(std::cos(seat.yaw) * y + std::sin(seat.yaw) * x);
    x = Cross(y, n);
    const Vec3d turned = std::cos(pitch) * y + std::sin(pitch) * n;
    const Vec3d up = std::cos(pitch) * n - std::sin(pitch) * y;
    const double c = std::cos(seat.roll), s = std::sin(seat.roll);
    return {seat.kind, seat.size, seat.at.p, c * x + s * up, turned, c * up - s * x};
}

/// Height over the surface by the tangent plane at the nearest sample.
double HeightOver(std::span<const SurfaceSample *const> surface, Vec3d p) {
    double nearest = Infinity, height = Infinity;
    for (const SurfaceSample *s : surface) {
        const double d = LengthSquared(s->p - p);
        if (d >= nearest) continue;
        nearest = d;
        height = Dot(p - s->p, s->n);
    }
    return height;
}

/// Height by which the feather must rise, and how far from its root.
struct Deficit {
    double height = 0, distance = 1;
    void Take(double missing, double at) {
        if (missing <= height) return;
        height = missing, distance = at;
    }
};

class Layer {
  public:
    Layer(std::span<const SurfaceSample> surface, Vec3d flow, const Parameters &p,
          std::span<const Sheet> sheets)
        : surface(surface), flow(flow), p(p), sheets(sheets) {}

    /// Lays a feather on those laid before.
    void Lay(const Seat &seat) {
        const Sheet &sheet = sheets[size_t(seat.kind)];
        FindNeighbours(seat, sheet.Length() * seat.size);
        double pitch = p.neckPitch;
        Placed feather = Stand(seat, flow, pitch);
        for (int i = 0; i < kMaxSteps; ++i) {
            const Deficit deficit = Missing(feather, sheet);
            if (deficit.height <= 0) break;
            pitch = std::min(kMaxPitch, pitch + 1.02 * deficit.height / deficit.distance);
            feather = Stand(seat, flow, pitch);
            if (pitch == kMaxPitch) break;
        }
        placed.push_back(feather);
    }
    std::vector<Placed> Result() { return std::move(placed); }

  private:
    static constexpr int kMaxSteps = 40;
    static constexpr double kMaxPitch = 0.4;

    void FindNeighbours(const Seat &seat, double length) {
        below.clear();
        near.clear();
        for (const Placed &q : placed)
            if (LengthSquared(q.root - seat.at.p) <
                Sqr(length + sheets[size_t(q.kind)].Length() * q.scale))
                below.push_back(&q);
        for (const SurfaceSample &s : surface)
            if (LengthSquared(s.p - seat.at.p) < Sqr(1.3 * length)) near.push_back(&s);
    }

    Deficit Missing(const Placed &feather, const Sheet &sheet) const {
        Deficit deficit;
        for (const Vec3d &point : sheet.Spine()) {
            const Vec3d world = feather.ToWorld(point);
            deficit.Take(p.neckClearance - HeightOver(near, world), point.y * feather.scale);
        }
        for (const Vec3d &point : sheet.Points()) {
            const Vec3d world = feather.ToWorld(point);
            for (const Placed *q : below) {
                const Vec3d local = q->FromWorld(world);
                const auto height = sheets[size_t(q->kind)].Height(local.x, local.y);
                if (height)
                    deficit.Take(q->scale * (*height - local.z) + p.neckClearance,
                                 point.y * feather.scale);
            }
        }
        return deficit;
    }

    std::span<const SurfaceSample> surface;
    Vec3d flow;
    const Parameters &p;
    std::span<const Sheet> sheets;
    std::vector<Placed> placed;
    std::vector<const Placed *> below;
    std::vector<const SurfaceSample *> near;
};

}  // namespace

std::optional<std::vector<Placed>> Cover(std::span<const SurfaceSample> surface, Vec3d flow,
                                         const Parameters &p, std::span<const Sheet> sheets,
                                         uint64_t seed) {
    std::vector<SurfaceSample> roots = Spread(surface, p);
    if (roots.size() > kMostFeathers) return {};
    double begin = Infinity, end = -Infinity;
    for (const SurfaceSample &s : surface)
        begin = std::min(begin, Dot(s.p, flow)), end = std::max(end, Dot(s.p, flow));
    // Row after row, in a row as they came: in strict order a chain of neighbours round the neck
    // would rise higher and higher.
    const auto row = [&](const SurfaceSample &s) {
        return std::floor(s.along * (end - begin) / (0.8 * p.neckSpacing));
    };
    std::stable_sort(
        roots.begin(), roots.end(),
        [&](const SurfaceSample &a, const SurfaceSample &b) { return row(a) > row(b); });

    Rng rng(seed);
    const auto spread = [&](double size) { return size * (2 * double(rng.Uniform()) - 1); };
    constexpr size_t kSamplesForHeights = 6000;
    Layer layer(surface.first(std::min(surface.size(), kSamplesForHeights)), flow, p, sheets);
    for (const SurfaceSample &root : roots) {
        Seat seat{};
        seat.at = root;
        seat.size = SizeAt(p, root.along) * (1 + spread(p.neckJitter));
        const int color = ColorAt(root, p, end - begin, spread(0.5));
        seat.kind = color * int(p.neckShapes) + int(rng.Below(uint32_t(p.neckShapes)));
        seat.yaw = spread(2 * p.neckJitter);
        seat.roll = spread(p.neckJitter);
        layer.Lay(seat);
    }
    return layer.Result();
}

}  // namespace pbrt::feathergen
