#pragma once

#include <cmath>
#include <concepts>

#include "units.h"

namespace pbrt::feather {

/// Refractive index of feather keratin, transparent in the visible.
/// Source: Leertouwer, Wilts, Stavenga 2011, doi 10.1364/oe.19.024061.
template <std::floating_point T>
constexpr T KeratinIndex(Nm<T> lambda) {
    return T(1.532) + T(5890) / (lambda.value * lambda.value);
}

/// Complex refractive index n + ik of melanin.
template <std::floating_point T>
struct ComplexIndex {
    T n, k;
};

/// Source: Stavenga et al. 2015, doi 10.1038/lsa.2015.16.
template <std::floating_point T>
ComplexIndex<T> MelaninIndex(Nm<T> lambda) {
    return {T(1.648) + T(23700) / (lambda.value * lambda.value),
            T(0.56) * std::exp(-lambda.value / T(270))};
}

/// Power reflected at normal incidence by melanin in air, taken as its diffuse reflectance
/// (MODEL section 2).
template <std::floating_point T>
T MelaninReflectance(Nm<T> lambda) {
    const auto [n, k] = MelaninIndex(lambda);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

}  // namespace pbrt::feather
