#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "oracle/vector.h"

namespace pbrt::oracle {

/// A partition of the sphere into bins that hold about the same power each: first by the azimuth
/// across the barbules, atan2(x, z), then by y.
class DirectionBins {
  public:
    struct Ray {
        Vec3 w;
        double power;
    };
    /// `pilot` tells where the power goes.
    DirectionBins(std::vector<Ray> pilot, int azimuths, int heights) {
        azimuthEdges = Quantiles(pilot, azimuths, [](Vec3 w) { return Azimuth(w); });
        for (int i = 0; i < azimuths; ++i) {
            std::vector<Ray> part;
            for (const Ray &ray : pilot)
                if (Index(azimuthEdges, Azimuth(ray.w)) == std::size_t(i)) part.push_back(ray);
            heightEdges.push_back(Quantiles(part, heights, [](Vec3 w) { return w.y; }));
        }
    }
    std::size_t Size() const { return heightEdges.size() * (heightEdges[0].size() + 1); }
    std::size_t operator()(Vec3 w) const {
        const std::size_t i = Index(azimuthEdges, Azimuth(w));
        return i * (heightEdges[0].size() + 1) + Index(heightEdges[i], w.y);
    }

  private:
    static double Azimuth(Vec3 w) { return std::atan2(w.x, w.z); }

    /// The interval that x lies in; its lower end belongs to it.
    static std::size_t Index(const std::vector<double> &edges, double x) {
        return std::upper_bound(edges.begin(), edges.end(), x) - edges.begin();
    }

    template <class Key>
    static std::vector<double> Quantiles(std::vector<Ray> rays, int parts, const Key &key) {
        std::sort(rays.begin(), rays.end(),
                  [&](const Ray &a, const Ray &b) { return key(a.w) < key(b.w); });
        double all = 0, sum = 0;
        for (const Ray &ray : rays)
            all += ray.power;
        std::vector<double> edges;
        for (const Ray &ray : rays) {
            sum += ray.power;
            while (int(edges.size()) < parts - 1 && sum >= all * double(edges.size() + 1) / parts)
                edges.push_back(key(ray.w));
        }
        edges.resize(parts - 1, edges.empty() ? 0 : edges.back());
        return edges;
    }

    std::vector<double> azimuthEdges;
    std::vector<std::vector<double>> heightEdges;
};

}  // namespace pbrt::oracle
