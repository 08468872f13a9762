#include "pbrt/spectra/sigmoid_fit.h"

#include <cmath>

#include "pbrt/spectra/tables.h"

namespace pbrt {
namespace {

constexpr double Centre = 595, HalfWidth = 235;  // nm
/// Steeper quadratics have edges narrower than the 1 nm at which spectra are summed.
constexpr double LargestParameter = 1e4;

/// CIELAB's companded ratio and its derivative; linear below (6/29)^3, also for negative ratios.
struct Companded {
    double f, derivative;
};
Companded Compand(double ratio) {
    constexpr double delta = 6.0 / 29, slope = 1 / (3 * delta * delta);
    if (ratio <= delta * delta * delta) return {slope * ratio + 4.0 / 29, slope};
    const double root = std::cbrt(ratio);
    return {root, 1 / (3 * root * root)};
}
Triple LabOfCompanded(double x, double y, double z) {
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}
double SquaredNorm(const Triple &v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// Solves the symmetric positive definite a x = b by Cholesky's factors.
Triple SolveSymmetric(std::array<Triple, 3> a, Triple b) {
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < i; ++k)
            a[i][i] -= a[i][k] * a[i][k];
        a[i][i] = std::sqrt(a[i][i]);
        for (int j = i + 1; j < 3; ++j) {
            for (int k = 0; k < i; ++k)
                a[j][i] -= a[i][k] * a[j][k];
            a[j][i] /= a[i][i];
        }
        for (int k = 0; k < i; ++k)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (int i = 2; i >= 0; --i) {
        for (int k = i + 1; k < 3; ++k)
            b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    return b;
}

}  // namespace

RGBSigmoid ToSigmoid(const SigmoidParameters &p) {
    const double a = p[0] / (HalfWidth * HalfWidth), b = p[1] / HalfWidth;
    return {float(a), float(b - 2 * a * Centre), float((a * Centre - b) * Centre + p[2])};
}

/// Parameters with the CIELAB difference to the target and its derivatives.
struct SigmoidFit::Trial {
    SigmoidParameters p;
    Triple residual;
    std::array<Triple, 3> jacobian;  ///< [Lab][parameter]
    double error;                    ///< squared norm of the residual
};

SigmoidFit::SigmoidFit(const Spectrum &illuminant) : position(Blocks) {
    namespace t = spectra::tables;
    const std::array<const std::array<float, 471> *, 3> matching{&t::cieX, &t::cieY, &t::cieZ};
    double luminance = 0;
    for (int i = 0; i < DenseTable::Size; ++i)
        luminance += t::cieY[i] * double(illuminant(LambdaMin + i));
    for (auto &w : weight)
        w.resize(Blocks);
    for (int i = 0; i < DenseTable::Size; ++i) {
        position[i / 4][i % 4] = (i + LambdaMin - Centre) / HalfWidth;
        for (int c = 0; c < 3; ++c) {
            const double w = (*matching[c])[i] * double(illuminant(LambdaMin + i)) / luminance;
            weight[c][i / 4][i % 4] = w;
            white[c] += w;
        }
    }
}

Triple SigmoidFit::Lab(const Triple &xyz) const {
    return LabOfCompanded(Compand(xyz[0] / white[0]).f, Compand(xyz[1] / white[1]).f,
                          Compand(xyz[2] / white[2]).f);
}

/// For each matching function: the colour, and its derivatives by the three parameters.
std::array<std::array<double, 4>, 3> SigmoidFit::Moments(const SigmoidParameters &p) const {
    std::array<std::array<Lanes, 4>, 3> sums{};
    for (int block = 0; block < Blocks; ++block) {
        const Lanes t = position[block];
        const Lanes x = (p[0] * t + p[1]) * t + p[2];
        const Lanes square = 1 + x * x;
        const Lanes r = 1 / Lanes{std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]),
                                  std::sqrt(square[3])};
        const Lanes value = 0.5 + 0.5 * x * r, slope = 0.5 * r * r * r;
        for (int c = 0; c < 3; ++c) {
            const Lanes w = weight[c][block];
            sums[c][0] += w * value;
            sums[c][1] += w * slope * t * t;
            sums[c][2] += w * slope * t;
            sums[c][3] += w * slope;
        }
    }
    std::array<std::array<double, 4>, 3> moments;
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 4; ++k) {
            const Lanes s = sums[c][k];
            moments[c][k] = (s[0] + s[1]) + (s[2] + s[3]);
        }
    return moments;
}

SigmoidFit::Trial SigmoidFit::Try(const SigmoidParameters &p, const Triple &targetLab) const {
    const auto moments = Moments(p);
    double f[3], df[3][3];
    for (int c = 0; c < 3; ++c) {
        const Companded companded = Compand(moments[c][0] / white[c]);
        f[c] = companded.f;
        for (int k = 0; k < 3; ++k)
            df[c][k] = companded.derivative * moments[c][k + 1] / white[c];
    }
    Trial trial{p, LabOfCompanded(f[0], f[1], f[2]), {}, 0};
    for (int k = 0; k < 3; ++k) {
        trial.residual[k] -= targetLab[k];
        trial.jacobian[0][k] = 116 * df[1][k];
        trial.jacobian[1][k] = 500 * (df[0][k] - df[1][k]);
        trial.jacobian[2][k] = 200 * (df[1][k] - df[2][k]);
    }
    trial.error = SquaredNorm(trial.residual);
    return trial;
}

SigmoidFit::Result SigmoidFit::Fit(const Triple &xyz, const SigmoidParameters &start) const {
    constexpr double Enough = 1e-5;  // CIELAB units; 0.5 is just visible
    const Triple target = Lab(xyz);
    Trial best = Try(start, target);
    double damping = 1e-4;
    for (int i = 0; i < 60 && best.error > Sqr(Enough) && damping < 1e8; ++i) {
        // Gauss and Newton's step, damped after Levenberg and Marquardt.
        std::array<Triple, 3> normal{};
        Triple gradient{};
        for (int j = 0; j < 3; ++j)
            for (int row = 0; row < 3; ++row) {
                gradient[j] -= best.jacobian[row][j] * best.residual[row];
                for (int k = 0; k < 3; ++k)
                    normal[j][k] += best.jacobian[row][j] * best.jacobian[row][k];
            }
        for (int j = 0; j < 3; ++j)
            normal[j][j] += damping * normal[j][j] + 1e-12;
        const Triple step = SolveSymmetric(normal, gradient);
        SigmoidParameters p = best.p;
        for (int j = 0; j < 3; ++j)
            p[j] = std::clamp(p[j] + step[j], -LargestParameter, LargestParameter);
        const Trial next = Try(p, target);
        if (next.error < best.error) {
            best = next;
            damping *= 0.1;
        } else {
            damping *= 10;
        }
    }
    return {best.p, std::sqrt(best.error)};
}

SigmoidFit::Result SigmoidFit::Fit(const Triple &xyz) const {
    const double grey = std::clamp(xyz[1], 1e-4, 1 - 1e-4);
    return Fit(xyz, {0, 0, (grey - 0.5) / std::sqrt(grey * (1 - grey))});
}

Triple SigmoidFit::Color(const SigmoidParameters &p) const {
    const auto moments = Moments(p);
    return {moments[0][0], moments[1][0], moments[2][0]};
}

}  // namespace pbrt
