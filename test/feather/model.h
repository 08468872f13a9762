#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <ostream>
#include <random>
#include <vector>

#include "pbrt/feather/barbule.h"
#include "pbrt/feather/dispersion.h"
#include "pbrt/feather/pigment.h"

namespace pbrt::feather {

/// Parameters in double, from which the tests make barbules of either scalar.
struct Shape {
    double thickness = 590, spacing = 1.25, tilt = -0.35, aspect = 0.25, opening = 0.0785,
           roughness = 0;

    friend std::ostream &operator<<(std::ostream &out, const Shape &s) {
        return out << "thickness " << s.thickness << " spacing " << s.spacing << " tilt " << s.tilt
                   << " aspect " << s.aspect << " opening " << s.opening << " roughness "
                   << s.roughness;
    }
};

template <std::floating_point T>
BarbuleParams<T> ParamsOf(const Shape &s) {
    BarbuleParams<T> p;
    p.thickness = {T(s.thickness)};
    p.filmRoughness = {T(s.roughness)};
    p.spacing = T(s.spacing);
    p.tilt = {T(s.tilt)};
    p.aspect = T(s.aspect);
    p.opening = {T(s.opening)};
    return p;
}

template <std::floating_point T>
Row<T> RowOf(const Shape &s) {
    return {T(s.spacing), {T(s.tilt)}, T(s.aspect)};
}

template <std::floating_point T>
Bend<T> BendOf(const Shape &s) {
    return Bend<T>(Radian<T>{T(s.opening)});
}

/// Keratin over melanin at four wavelengths.
template <std::floating_point T>
Optics<T, 4> Feather(std::array<double, 4> lambda = {450, 520, 590, 660}) {
    Optics<T, 4> optics;
    for (int i = 0; i < 4; ++i) {
        optics.lambda[i] = T(lambda[i]);
        optics.eta[i] = T(KeratinIndex(Nm<double>{lambda[i]}));
        optics.melanin[i] = T(MelaninReflectance(Nm<double>{lambda[i]}));
    }
    return optics;
}

template <std::floating_point T, class Quadrature = AdaptiveRule>
Barbule<T, 4, Quadrature> BarbuleOf(const Shape &s, const Optics<T, 4> &optics = Feather<T>()) {
    return {ParamsOf<T>(s), optics};
}

/// theta from the normal in degrees, phi from the x axis in degrees.
inline Direction<double> Spherical(double theta, double phi) {
    const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

template <std::floating_point T>
Direction<T> Rounded(Direction<double> w) {
    return {T(w.x), T(w.y), T(w.z)};
}

/// Directions and shapes for random laws; the seed is fixed.
class Dice {
  public:
    explicit Dice(unsigned seed) : engine(seed) {}
    double Uniform(double lo = 0, double hi = 1) {
        return lo + (hi - lo) * (double(engine()) / 4294967296.0);
    }
    double LogUniform(double lo, double hi) {
        return std::exp(Uniform(std::log(lo), std::log(hi)));
    }
    Direction<double> OnSphere() {
        const double z = Uniform(-1, 1), phi = Uniform(0, 2 * std::numbers::pi);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    Direction<double> OnUpperHemisphere() {
        Direction<double> w = OnSphere();
        w.z = std::abs(w.z);
        return w;
    }
    Shape AnyShape() {
        return {Uniform(0, 2000), LogUniform(0.2, 8), Uniform(-1.57, 1.57), LogUniform(0.05, 4),
                LogUniform(0.002, 1.5)};
    }

  private:
    std::mt19937 engine;
};

/// Shapes that the paper, the anchors and the hard cases name.
inline const std::vector<Shape> kShapes{
    {},
    {.aspect = 1},
    {.spacing = 2.5},
    {.spacing = 0.3},
    {.tilt = -0.8},
    {.tilt = 0.3},
    {.opening = 0.1571},
    {.spacing = 2.5, .tilt = -0.8, .opening = 0.9},
};

}  // namespace pbrt::feather
