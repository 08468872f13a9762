#include "pbrt/lights/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pbrt {
namespace {

struct Item {
    LightBounds bounds;
    Point3f center;
    int light;
};
using Items = std::span<Item>;

LightBounds BoundsOf(Items items) {
    LightBounds b;
    for (const Item &item : items)
        b = Union(b, item.bounds);
    return b;
}

/// Conty Estevez and Kulla 2018, equation 1: how wide the emitters shine.
float OrientationMeasure(const LightBounds &b) {
    const float o = std::acos(std::clamp(b.normals.cosTheta, -1.f, 1.f));
    const float w = std::min(Pi, o + std::acos(std::clamp(b.cosTheta_e, -1.f, 1.f)));
    return 2 * Pi * (1 - std::cos(o)) +
           Pi / 2 * (2 * w * std::sin(o) - std::cos(o - 2 * w) - 2 * o * std::sin(o) + std::cos(o));
}

/// Their surface area orientation measure, times power.
float Cost(const LightBounds &b) {
    if (b.power == 0) return 0;
    const Vector3f d = b.bounds.Diagonal();
    const float area = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
    // Points on a line have no area; their spread still counts.
    const float spread = area + 1e-4f * LengthSquared(d);
    return b.power * OrientationMeasure(b) * spread;
}

struct Split {
    float cost = Infinity;
    int axis = 0;
    float at = 0;  ///< centers below go left
};

/// The best of 11 planes across one axis.
void TryAxis(Items items, const Bounds3f &centers, int axis, float slenderness, Split *best) {
    constexpr int kBuckets = 12;
    const float lo = centers.min[axis], width = centers.max[axis] - lo;
    if (!(width > 0) || !std::isfinite(width)) return;
    std::array<LightBounds, kBuckets> buckets;
    for (const Item &item : items) {
        const int b = int(kBuckets * ((item.center[axis] - lo) / width));
        LightBounds &bucket = buckets[size_t(std::clamp(b, 0, kBuckets - 1))];
        bucket = Union(bucket, item.bounds);
    }
    std::array<float, kBuckets> right{};  // cost of buckets i and above
    LightBounds sum;
    for (size_t i = kBuckets; i-- > 1;) {
        sum = Union(sum, buckets[i]);
        right[i] = Cost(sum);
    }
    sum = {};
    for (size_t i = 1; i < kBuckets; ++i) {
        sum = Union(sum, buckets[i - 1]);
        const float cost = slenderness * (Cost(sum) + right[i]);
        if (cost < best->cost) *best = {cost, axis, lo + width * float(i) / kBuckets};
    }
}

/// Number of items that go left; the items are ordered accordingly. At least 1 on either side.
size_t SplitItems(Items items, bool halve) {
    Bounds3f centers;
    for (const Item &item : items)
        centers.Grow(item.center);
    const Vector3f extent = centers.Diagonal();
    Split best;
    for (int axis = 0; axis < 3 && !halve; ++axis)
        if (extent[axis] > 0)
            TryAxis(items, centers, axis, MaxComponent(extent) / extent[axis], &best);
    if (best.cost < Infinity) {
        const auto middle = std::partition(items.begin(), items.end(), [&](const Item &item) {
            return item.center[best.axis] < best.at;
        });
        const size_t n = size_t(middle - items.begin());
        if (n > 0 && n < items.size()) return n;
    }
    // Deep trees and lights in one place: halves along the widest axis.
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                     : extent.y >= extent.z                       ? 1
                                                                  : 2;
    const size_t n = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(n), items.end(),
                     [&](const Item &a, const Item &b) {
                         return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis]
                                                                 : a.light < b.light;
                     });
    return n;
}

}  // namespace

/// Builds nodes depth first.
class LightTreeBuilder {
  public:
    explicit LightTreeBuilder(LightTree &tree) : tree(tree) {}

    int32_t Build(Items items, int level, uint64_t path) {
        const int32_t index = int32_t(tree.nodes.size());
        tree.nodes.emplace_back();
        std::array<Items, kPacketSize> parts;
        const int n = Divide(items, level, parts);
        for (int i = 0; i < n; ++i) {
            const Items part = parts[size_t(i)];
            const ClusterOf<float> cluster = Cluster(BoundsOf(part));
            const uint64_t childPath = path | uint64_t(i) << (4 * level);
            int32_t child = ~int32_t(part[0].light);
            if (part.size() == 1)
                tree.paths[size_t(part[0].light)] = childPath;
            else
                child = Build(part, level + 1, childPath);
            tree.nodes[size_t(index)].Set(i, cluster, child);
        }
        return index;
    }

  private:
    /// Splits the largest part until there are sixteen or all are single; below the root, where
    /// there are more than sixteen lights, also once each part fits one node: nodes well filled
    /// make a small tree.
    static int Divide(Items items, int level, std::array<Items, kPacketSize> &parts) {
        int n = 1;
        parts[0] = items;
        const size_t enough = level > 0 && items.size() > kPacketSize ? kPacketSize : 1;
        while (n < kPacketSize) {
            const auto largest = std::max_element(
                parts.begin(), parts.begin() + n,
                [](const Items &a, const Items &b) { return a.size() < b.size(); });
            if (largest->size() <= enough) break;
            // Halving on the lower 8 levels ends any tree of fewer than 16^8 lights in time.
            const Items whole = *largest;
            const size_t left = SplitItems(whole, level >= LightTree::kMaxLevels / 2);
            // Halves stay neighbours, so that close random numbers draw close lights.
            std::move_backward(largest + 1, parts.begin() + n, parts.begin() + n + 1);
            largest[0] = whole.first(left), largest[1] = whole.subspan(left);
            ++n;
        }
        return n;
    }

    LightTree &tree;
};

void LightTree::Node::Set(int i, const ClusterOf<float> &c, int32_t to) {
    SetLane(&clusters.center, i, c.center);
    SetLane(&clusters.axis, i, c.axis);
    clusters.radius.Set(i, c.radius);
    clusters.spread.Set(i, c.spread);
    clusters.cosTheta_e.Set(i, c.cosTheta_e);
    clusters.signedPower.Set(i, c.signedPower);
    child.Set(i, to);
}

void LightTree::ChildWeights(const Walk *walks, LaneBits lanes, Weights *weights) const {
    ForEachLane(lanes, [&](int i) {
        const Walk &walk = walks[i];
        const FloatX16 w = Importance(nodes[size_t(walk.at)].clusters, walk.to);
        weights[i] = {w, InclusiveScan(w)};
    });
}

LightTree::LightTree(std::span<const LightBounds> lights) : paths(lights.size()) {
    std::vector<Item> items;
    items.reserve(lights.size());
    for (size_t i = 0; i < lights.size(); ++i)
        items.push_back({lights[i], lights[i].bounds.Center(), int(i)});
    if (items.empty()) return;
    LightTreeBuilder(*this).Build(items, 0, 0);
    nodes.shrink_to_fit();
}

}  // namespace pbrt
