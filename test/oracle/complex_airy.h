#pragma once

#include <cmath>
#include <complex>
#include <numbers>

namespace pbrt::oracle {

using Complex = std::complex<double>;

/// Light in air meets a film with air behind it; lengths in one unit, `index` >= 1.
struct AiryFilm {
    double lambda, thickness, index;
};

/// Complex reflection and transmission coefficients of a film.
struct Amplitudes {
    Complex r, t;
};

enum class Polarisation { S, P };

/// Fresnel's coefficients for light that goes from an index into another; complex when it is
/// totally reflected, else real. For p the sign of r is that of the magnetic field.
template <class Number>
struct Interface {
    Number r, t;
};
template <class Number>
Interface<Number> Fresnel(Polarisation p, double n1, Number cos1, double n2, Number cos2) {
    const bool s = p == Polarisation::S;
    const Number a = n1 * (s ? cos1 : cos2), b = n2 * (s ? cos2 : cos1);
    return {s ? (a - b) / (a + b) : (b - a) / (a + b), 2 * n1 * cos1 / (a + b)};
}

inline double CosineInside(double index, double cosine) {
    return std::sqrt(1 - (1 - cosine * cosine) / (index * index));
}

/// Phase of one passage to and fro, 2 pi D / lambda with S-sec.1's D = 2 d eta cos(beta).
inline Complex RoundTrip(const AiryFilm &f, double cosine) {
    return std::polar(1.0, 4 * std::numbers::pi * f.thickness * f.index *
                               CosineInside(f.index, cosine) / f.lambda);
}

/// S-eq.1 and S-eq.2 in closed form. For grazing incidence, 1 - r^2 e^(i psi) cancels: below a
/// cosine of 1e-3 the relative error exceeds 1e-10.
inline Amplitudes AirySum(const AiryFilm &f, double cosine, Polarisation p) {
    const double inside = CosineInside(f.index, cosine);
    const Interface<double> ak = Fresnel(p, 1, cosine, f.index, inside);
    const Interface<double> ka = Fresnel(p, f.index, inside, 1, cosine);
    const Complex turn = RoundTrip(f, cosine), loop = 1.0 - ka.r * ka.r * turn;
    return {ak.r + ak.t * ka.r * ka.t * turn / loop, ak.t * ka.t / loop};
}

/// The same series summed term by term, `terms` passages to and fro.
inline Amplitudes AirySeries(const AiryFilm &f, double cosine, Polarisation p, int terms) {
    const double inside = CosineInside(f.index, cosine);
    const Interface<double> ak = Fresnel(p, 1, cosine, f.index, inside);
    const Interface<double> ka = Fresnel(p, f.index, inside, 1, cosine);
    const Complex turn = RoundTrip(f, cosine);
    Amplitudes sum{ak.r, 0};
    Complex wave = ak.t;
    for (int n = 0; n < terms; ++n) {
        sum.t += wave * ka.t;
        sum.r += wave * ka.r * turn * ka.t;
        wave *= ka.r * ka.r * turn;
    }
    return sum;
}

/// The same from Maxwell's equations by the film's characteristic matrix (Yeh, chapter 5):
/// tangential fields (E, H) at its front follow from those at its back. |t| without S-eq.2's phase.
inline Amplitudes TransferMatrix(const AiryFilm &f, double cosine, Polarisation p) {
    const double inside = CosineInside(f.index, cosine);
    const bool s = p == Polarisation::S;
    const double air = s ? cosine : 1 / cosine;
    const double film = s ? f.index * inside : f.index / inside;
    const double phase = 2 * std::numbers::pi * f.thickness * f.index * inside / f.lambda;
    const Complex i(0, 1);
    const Complex e = std::cos(phase) - i * std::sin(phase) / film * air;
    const Complex h = std::cos(phase) * air - i * film * std::sin(phase);
    return {(air * e - h) / (air * e + h), 2 * air / (air * e + h)};
}

/// Unpolarised power.
struct Power {
    double r, t;
};
template <Amplitudes film(const AiryFilm &, double, Polarisation)>
Power Unpolarised(const AiryFilm &f, double cosine) {
    const Amplitudes s = film(f, cosine, Polarisation::S), p = film(f, cosine, Polarisation::P);
    return {(std::norm(s.r) + std::norm(p.r)) / 2, (std::norm(s.t) + std::norm(p.t)) / 2};
}

/// S-eq.3, the mean of both polarisations: in through the film at one angle, off the melanin with
/// coefficient r_am, out through the film at another.
inline double PigmentIntensity(const AiryFilm &f, double cosineIn, double cosineOut, Complex r_am) {
    double sum = 0;
    for (Polarisation p : {Polarisation::S, Polarisation::P}) {
        const Complex t = AirySum(f, cosineIn, p).t;
        const double inside = CosineInside(f.index, cosineOut);
        const Interface<double> ak = Fresnel(p, 1, cosineOut, f.index, inside);
        const Interface<double> ka = Fresnel(p, f.index, inside, 1, cosineOut);
        const Complex turn = RoundTrip(f, cosineOut);
        sum += std::norm(t * r_am * ak.t * ka.t / (1.0 - ka.r * ka.r * turn));
    }
    return sum / 2;
}

}  // namespace pbrt::oracle
