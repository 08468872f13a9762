#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "pbrt/filters/filter_table.h"
#include "pbrt/scene/params.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

// The profiles of the filters that pbrt-v4 has; see FilterProfile.

struct BoxProfile {
    static constexpr std::string_view kName = "box";
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"float xradius\" 1 \"float yradius\" 0.25"};
    static constexpr bool kClosedForm = true;
    static constexpr float kRadius = 0.5f;
    struct Shape {};
    static Shape Read(ParamDict &) { return {}; }

    BoxProfile(float radius, Shape) : radius(radius) {}
    float operator()(float x) const { return std::abs(x) <= radius ? 1 : 0; }
    double Integral() const { return 2 * radius; }
    AxisSample Sample(float u) const { return {(2 * u - 1) * radius, 2 * radius}; }

    float radius;
};

struct TriangleProfile {
    static constexpr std::string_view kName = "triangle";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"float xradius\" 0.5"};
    static constexpr bool kClosedForm = true;
    static constexpr float kRadius = 2;
    struct Shape {};
    static Shape Read(ParamDict &) { return {}; }

    TriangleProfile(float radius, Shape) : radius(radius) {}
    float operator()(float x) const { return std::max(0.f, radius - std::abs(x)); }
    double Integral() const { return double(radius) * radius; }
    AxisSample Sample(float u) const { return {SampleTent(u, radius), radius * radius}; }

    float radius;
};

/// Normal density of deviation sigma, lowered so that it ends at 0.
struct GaussianProfile {
    static constexpr std::string_view kName = "gaussian";
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"float sigma\" 2 \"float xradius\" 3"};
    static constexpr bool kClosedForm = false;
    static constexpr float kRadius = 1.5f;
    static constexpr FloatParam kSigma{"sigma", "pixels", 0.5f, 1e-3f, 1e3f, "standard deviation"};
    struct Shape {
        float sigma = 0.5f;
    };
    static Shape Read(ParamDict &params) { return {params.GetOneFloat(kSigma)}; }

    GaussianProfile(float radius, Shape shape)
        : radius(radius), sigma(shape.sigma), atRadius(Normal(radius)) {}
    float operator()(float x) const { return std::max(0.f, Normal(x) - atRadius); }
    double Integral() const {
        return std::erf(radius / (sigma * std::sqrt(2.0))) - 2.0 * radius * atRadius;
    }

    float radius, sigma, atRadius;

  private:
    float Normal(float x) const {
        return std::exp(-Sqr(x / sigma) / 2) / (std::sqrt(2 * Pi) * sigma);
    }
};

/// Cubic of Mitchell and Netravali 1988, two pixels wide on each side at radius 2.
struct MitchellProfile {
    static constexpr std::string_view kName = "mitchell";
    static constexpr std::array<std::string_view, 2> kExamples{"", "\"float B\" 1 \"float C\" 0"};
    static constexpr bool kClosedForm = false;
    static constexpr float kRadius = 2;
    static constexpr FloatParam kB{"B", "", 1.f / 3, -10, 10, "blur"};
    static constexpr FloatParam kC{"C", "", 1.f / 3, -10, 10, "ringing"};
    struct Shape {
        float b = 1.f / 3, c = 1.f / 3;
    };
    static Shape Read(ParamDict &params) {
        const float b = params.GetOneFloat(kB);
        return {b, params.GetOneFloat(kC)};
    }

    MitchellProfile(float radius, Shape shape) : radius(radius), b(shape.b), c(shape.c) {}
    float operator()(float offset) const {
        const float x = 2 * std::abs(offset / radius);
        if (x > 2) return 0;
        if (x < 1)
            return EvaluatePolynomial(x, 6 - 2 * b, 0.f, -18 + 12 * b + 6 * c, 12 - 9 * b - 6 * c) /
                   6;
        return Sqr(2 - x) * (b * (2 - x) + 6 * c * (1 - x)) / 6;
    }
    /// The cubic has integral 1 for every B and C.
    double Integral() const { return radius / 2; }

    float radius, b, c;
};

/// sinc(x) under the central lobe of sinc(x / tau) (Lanczos), sinc(x) = sin(pi x) / (pi x).
struct SincProfile {
    static constexpr std::string_view kName = "sinc";
    static constexpr std::array<std::string_view, 2> kExamples{
        "", "\"float tau\" 1 \"float yradius\" 2"};
    static constexpr bool kClosedForm = false;
    static constexpr float kRadius = 4;
    static constexpr FloatParam kTau{"tau", "pixels", 3, 1e-2f, 1e3f, "first zero of the window"};
    struct Shape {
        float tau = 3;
    };
    static Shape Read(ParamDict &params) { return {params.GetOneFloat(kTau)}; }

    SincProfile(float radius, Shape shape) : radius(radius), tau(shape.tau) {}
    float operator()(float x) const { return std::abs(x) > radius ? 0 : Sinc(x) * Sinc(x / tau); }
    double Integral() const;

    float radius, tau;

  private:
    /// Monotonic near 0: the quotient rounds to 1 there, and 0 itself is the only exception.
    static float Sinc(float x) {
        const double t = double(Pi) * x;
        return t == 0 ? 1 : float(std::sin(t) / t);
    }
};

/// Simpson's rule; relative error below 1e-6 for radii up to 32.
inline double SincProfile::Integral() const {
    const int n = 4096;
    const double h = double(radius) / n;
    double sum = (*this)(0) + (*this)(radius);
    for (int i = 1; i < n; ++i)
        sum += (i % 2 ? 4 : 2) * double((*this)(float(i * h)));
    return 2 * sum * h / 3;
}

}  // namespace pbrt
