#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "oracle/complex_airy.h"

namespace pbrt::oracle {

/// A hollow cylindrical tube of the film's material in air, as in S-fig.2a.
struct CurvedFilm {
    AiryFilm film;
    double radius;  ///< outer, in the film's unit of length, greater than its thickness
};

/// What one ray of S-fig.2a does: it enters at an angle of incidence, is reflected `order` times at
/// the inner surface and order - 1 times at the outer one, and leaves.
struct TubeRay {
    double incidence;  ///< at the outer surface
    double inside;     ///< its angle inside the film at the outer surface
    double inner;      ///< and at the inner one, greater: sin(inner) = sin(inside) r / (r - d)
    int order;

    TubeRay(const CurvedFilm &tube, double incidence, int order)
        : incidence(incidence),
          inside(std::asin(std::sin(incidence) / tube.film.index)),
          inner(std::asin(std::sin(inside) * tube.radius / (tube.radius - tube.film.thickness))),
          order(order) {}

    /// Azimuth of its axis of symmetry from where the light comes; it leaves at twice that. Between
    /// an outer and an inner point it turns by inner - inside about the tube's axis.
    double Axis() const { return incidence + order * (inner - inside); }

    /// Its optical path, against a plane wave that would be reflected at the tube's axis.
    double Path(const CurvedFilm &tube) const {
        const double r = tube.radius,
                     leg = r * std::cos(inside) - (r - tube.film.thickness) * std::cos(inner);
        return 2 * order * tube.film.index * leg - 2 * r * std::cos(incidence);
    }
};

/// The ray of this order whose axis is at azimuth `axis` in [0, pi/2], by bisection: it is
/// parallel, on its way out, to the one that the outer surface reflects there.
inline TubeRay RayWithAxis(const CurvedFilm &tube, double axis, int order) {
    double lo = 0, hi = axis;
    for (int i = 0; i < 60; ++i) {
        const double middle = (lo + hi) / 2;
        (TubeRay(tube, middle, order).Axis() > axis ? hi : lo) = middle;
    }
    return TubeRay(tube, (lo + hi) / 2, order);
}

/// Its amplitude: in, off the inner surface (total reflection where index sin(inner) > 1), out.
inline Complex Amplitude(const CurvedFilm &tube, const TubeRay &ray, double referencePath,
                         Polarisation p) {
    const double index = tube.film.index;
    const double outside = std::cos(ray.incidence), inside = std::cos(ray.inside);
    const auto in = Fresnel<double>(p, 1, outside, index, inside);
    const auto out = Fresnel<double>(p, index, inside, 1, outside);
    const double sine = index * std::sin(ray.inner);
    const auto inner =
        Fresnel<Complex>(p, index, std::cos(ray.inner), 1, std::sqrt(Complex(1 - sine * sine)));
    const double turns = (ray.Path(tube) - referencePath) / tube.film.lambda;
    return in.t * out.t * std::pow(out.r, ray.order - 1) * std::pow(inner.r, ray.order) *
           std::polar(1.0, 2 * std::numbers::pi * turns);
}

/// Unpolarised reflectance of the tube where the angle between the light's way in and its way out
/// is `angle`, in [0, pi): all orders of the rays that leave in parallel interfere (S-sec.1).
///
/// As in S the curvature enters by the rays' angles and paths; that rays of different orders spread
/// differently is left out, so that beyond the onset of total reflection the value can exceed 1.
inline double Reflectance(const CurvedFilm &tube, double angle) {
    const double reference = TubeRay(tube, angle / 2, 0).Path(tube);
    double power = 0;
    for (Polarisation p : {Polarisation::S, Polarisation::P}) {
        const double inside = CosineInside(tube.film.index, std::cos(angle / 2));
        Complex sum = Fresnel<double>(p, 1, std::cos(angle / 2), tube.film.index, inside).r;
        for (int order = 1; order <= 40; ++order)
            sum += Amplitude(tube, RayWithAxis(tube, angle / 2, order), reference, p);
        power += std::norm(sum) / 2;
    }
    return power;
}

}  // namespace pbrt::oracle
