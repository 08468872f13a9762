#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

#include "bend.h"
#include "direction.h"
#include "quadrature.h"
#include "row.h"
#include "thin_film.h"

namespace pbrt::feather {

/// The points of a segment that two directions see, as eccentric angles; empty unless lo < hi.
template <std::floating_point T>
Interval<T> SeenFromBoth(const RowView<T> &o, const RowView<T> &i) {
    const T angle = std::atan2(o.image.x, o.image.n);
    const T turn = std::atan2(Cross(o.image, i.image), Dot(o.image, i.image));
    const auto end = [](const RowView<T> &w, T q) { return std::asin(q / w.reach); };
    return {angle + std::max(end(o, o.lower), turn + end(i, i.lower)),
            angle + std::min(end(o, o.upper), turn + end(i, i.upper))};
}

/// The integral of TRT, as MODEL section 5 writes it: per wavelength, the mean over the vane of
/// V_wo V_wi (T_s T_s + T_p T_p)/2 (m.wo)(m.wi) per facet. Times R_m / (pi |wo.z| |wi.z|) it is
/// f_TRT.
///
/// Gauss-Legendre in the bend angle a and the eccentric angle e, over what both directions see,
/// with `panelsA` by `panelsE` equal panels of NodesA by NodesE points.
template <int NodesE, int NodesA, std::floating_point T, std::size_t N>
std::array<T, N> PigmentIntegral(const Row<T> &row, const Bend<T> &bend,
                                 const std::array<Film<T>, N> &films, Direction<T> wo,
                                 Direction<T> wi, int panelsE = 1, int panelsA = 1) {
    const auto &ruleA = kGaussLegendre<T, NodesA>;
    const auto &ruleE = kGaussLegendre<T, NodesE>;
    const Interval<T> rangeO = bend.SeenFrom(wo), rangeI = bend.SeenFrom(wi);
    const T a0 = std::max(rangeO.lo, rangeI.lo), a1 = std::min(rangeO.hi, rangeI.hi);
    std::array<T, N> sum{};
    if (!(a0 < a1)) return sum;
    const T halfA = (a1 - a0) / (2 * panelsA);
    for (int ka = 0; ka < panelsA * NodesA; ++ka) {
        const T a = a0 + halfA * (2 * (ka / NodesA) + 1 + ruleA.node[ka % NodesA]);
        const Segment<T> segment{std::sin(a), std::cos(a)};
        const RowView<T> o = row.SeenFrom(segment.Across(wo));
        const RowView<T> i = row.SeenFrom(segment.Across(wi));
        const auto [e0, e1] = SeenFromBoth(o, i);
        if (!(e0 < e1)) continue;
        const T halfE = (e1 - e0) / (2 * panelsE);
        for (int ke = 0; ke < panelsE * NodesE; ++ke) {
            const T e = e0 + halfE * (2 * (ke / NodesE) + 1 + ruleE.node[ke % NodesE]);
            const Planar<T> point{std::cos(e), std::sin(e)};
            const T length = std::hypot(point.n, row.Aspect() * point.x);
            const auto cosine = [&](const RowView<T> &w) {
                return std::max(T(0), row.Aspect() * Dot(w.image, point) / length);
            };
            const T cosO = cosine(o), cosI = cosine(i);
            const T dA = length * halfE * ruleE.weight[ke % NodesE] * halfA *
                         ruleA.weight[ka % NodesA] / (2 * row.Spacing() * bend.SinOpening());
            for (std::size_t k = 0; k < N; ++k) {
                const Polarised<T> in = films[k].Transmittance(cosO);
                const Polarised<T> out = films[k].Transmittance(cosI);
                sum[k] += dA * cosO * cosI * (in.s * out.s + in.p * out.p) / 2;
            }
        }
    }
    return sum;
}

/// Number of nodes in a that the integral needs: more where the arc is bent more (MODEL section 5).
template <std::floating_point T>
constexpr int BendNodes(T opening) {
    return opening <= T(0.3) ? 2 : opening <= T(0.6) ? 3 : opening <= 1 ? 4 : 6;
}

/// A quadrature for Barbule: one Gauss-Legendre panel of NodesE by BendNodes points.
template <int NodesE>
struct GaussPanel {
    template <std::floating_point T, std::size_t N>
    static void Integrate(const Row<T> &row, const Bend<T> &bend,
                          const std::array<Film<T>, N> &films, const Direction<T> &wo,
                          const Direction<T> &wi, std::array<T, N> *integral) {
        switch (BendNodes(bend.Opening())) {
            case 2:
                *integral = PigmentIntegral<NodesE, 2>(row, bend, films, wo, wi);
                break;
            case 3:
                *integral = PigmentIntegral<NodesE, 3>(row, bend, films, wo, wi);
                break;
            case 4:
                *integral = PigmentIntegral<NodesE, 4>(row, bend, films, wo, wi);
                break;
            default:
                *integral = PigmentIntegral<NodesE, 6>(row, bend, films, wo, wi);
                break;
        }
    }
};

/// A quadrature for the oracle: panels enough that only edges of what is seen are left as error.
template <int PanelsE, int PanelsA>
struct Converged {
    template <std::floating_point T, std::size_t N>
    static void Integrate(const Row<T> &row, const Bend<T> &bend,
                          const std::array<Film<T>, N> &films, const Direction<T> &wo,
                          const Direction<T> &wi, std::array<T, N> *integral) {
        *integral = PigmentIntegral<16, 8>(row, bend, films, wo, wi, PanelsE, PanelsA);
    }
};

}  // namespace pbrt::feather
