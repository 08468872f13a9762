#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "pbrt/util/check.h"
#include "pbrt/util/vecmath.h"

namespace pbrt {

/// Draws one of n things in constant time with probabilities proportional to given weights
/// (Walker 1977; tables filled by Vose 1991). Immutable after construction.
class AliasTable {
  public:
    struct IndexSample {
        int index;
        float pmf;  ///< probability of `index`
        float u;    ///< in [0, 1): what is left of the random number; about 24 - log2(n) bits
    };

    AliasTable() = default;
    /// `weights`: finite, none negative; where all are 0 each thing is equally likely.
    explicit AliasTable(std::span<const float> weights);

    /// u in [0, 1). The table must not be empty. Never draws a thing of probability 0.
    IndexSample Sample(float u) const {
        DCHECK(!bins.empty());
        const float scaled = u * float(bins.size());
        const int slot = std::min(int(scaled), int(bins.size()) - 1);
        const float rest = std::min(scaled - float(slot), OneMinusEpsilon);
        const Bin &bin = bins[size_t(slot)];
        if (rest < bin.keep) return {slot, bin.pmf, std::min(rest / bin.keep, OneMinusEpsilon)};
        const float left = std::min((rest - bin.keep) / (1 - bin.keep), OneMinusEpsilon);
        return {bin.alias, bins[size_t(bin.alias)].pmf, left};
    }
    float PMF(int index) const { return bins[size_t(index)].pmf; }
    size_t Size() const { return bins.size(); }

  private:
    struct Bin {
        float keep;  ///< part of the slot that belongs to the slot's own thing
        float pmf;
        int alias;  ///< owner of the rest
    };
    std::vector<Bin> bins;
};

inline AliasTable::AliasTable(std::span<const float> weights) {
    const size_t n = weights.size();
    double sum = 0;
    for (float w : weights) {
        DCHECK(w >= 0 && w < Infinity);
        sum += w;
    }
    bins.resize(n);
    // Content of each slot in units of the mean: slots with less are filled up from those with
    // more.
    std::vector<double> content(n);
    std::vector<int> poor, rich;
    for (size_t i = 0; i < n; ++i) {
        const double p = sum > 0 ? weights[i] / sum : 1.0 / double(n);
        content[i] = float(p) > 0 ? p * double(n) : 0;
        bins[i] = {1, float(p), int(i)};
        (content[i] < 1 ? poor : rich).push_back(int(i));
    }
    while (!poor.empty() && !rich.empty()) {
        const size_t small = size_t(poor.back()), large = size_t(rich.back());
        poor.pop_back();
        bins[small].keep = float(content[small]);
        bins[small].alias = int(large);
        content[large] -= 1 - content[small];
        if (content[large] < 1) {
            rich.pop_back();
            poor.push_back(int(large));
        }
    }
    // Left over by rounding: full slots, but never give one to a thing of weight 0.
    const auto likeliest = std::max_element(
        bins.begin(), bins.end(), [](const Bin &a, const Bin &b) { return a.pmf < b.pmf; });
    for (int i : poor) {
        if (bins[size_t(i)].pmf == 0) bins[size_t(i)] = {0, 0, int(likeliest - bins.begin())};
    }
}

}  // namespace pbrt
