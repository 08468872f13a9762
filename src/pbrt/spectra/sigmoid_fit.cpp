#include "pbrt/spectra/sigmoid_fit.h"

#include <algorithm>
#include <cmath>

#include "pbrt/spectra/tables.h"

namespace pbrt {
namespace {

constexpr double Centre = 595, HalfWidth = 235;  // nm
/// Steeper quadratics have edges narrower than the 1 nm at which spectra are summed.
constexpr double LargestParameter = 3000;

double SquaredNorm(const Triple &v) {
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/// Solves the symmetric positive definite a x = b by Cholesky's factors.
Triple SolveSymmetric(Matrix3d a, Triple b) {
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < i; ++k)
            a[i][i] -= a[i][k] * a[i][k];
        a[i][i] = std::sqrt(std::max(a[i][i], 1e-300));
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

/// Parameters with the difference of their colour to the target, and its derivatives.
struct SigmoidFit::Trial {
    SigmoidParameters p;
    Triple residual;
    Matrix3d jacobian;  ///< [colour component][parameter]
    double error;       ///< squared norm of the residual

    /// Gauss and Newton's step, damped after Levenberg and Marquardt.
    SigmoidParameters Next(double damping) const {
        Matrix3d normal{};
        Triple gradient{};
        for (int j = 0; j < 3; ++j)
            for (int row = 0; row < 3; ++row) {
                gradient[j] -= jacobian[row][j] * residual[row];
                for (int k = 0; k < 3; ++k)
                    normal[j][k] += jacobian[row][j] * jacobian[row][k];
            }
        for (int j = 0; j < 3; ++j)
            normal[j][j] += damping * normal[j][j];
        const Triple step = SolveSymmetric(normal, gradient);
        SigmoidParameters next;
        for (int j = 0; j < 3; ++j)
            next[j] = std::clamp(p[j] + step[j], -LargestParameter, LargestParameter);
        return next;
    }
};

SigmoidFit::SigmoidFit(const Spectrum &illuminant, const Matrix3d &rgbFromXYZ) : position(Blocks) {
    namespace t = spectra::tables;
    double luminance = 0;
    for (int i = 0; i < DenseTable::Size; ++i)
        luminance += t::cieY[i] * double(illuminant(LambdaMin + i));
    for (auto &w : weight)
        w.resize(Blocks);
    for (int i = 0; i < DenseTable::Size; ++i) {
        const double power = illuminant(LambdaMin + i) / luminance;
        const Triple rgb =
            Mul(rgbFromXYZ, Triple{power * t::cieX[i], power * t::cieY[i], power * t::cieZ[i]});
        position[i / 4].Set(i % 4, (i + LambdaMin - Centre) / HalfWidth);
        for (int c = 0; c < 3; ++c)
            weight[c][i / 4].Set(i % 4, rgb[c]);
    }
}

SigmoidFit::Trial SigmoidFit::Try(const SigmoidParameters &p, const Triple &rgb) const {
    // For each component: its value and its derivatives by the three parameters.
    std::array<std::array<DoubleX4, 4>, 3> sums{};
    for (int block = 0; block < Blocks; ++block) {
        const DoubleX4 t = position[block];
        const DoubleX4 x = (p[0] * t + p[1]) * t + p[2];
        const DoubleX4 square = 1 + x * x;
        const DoubleX4 r = 1 / Sqrt(square);
        const DoubleX4 value = 0.5 + 0.5 * x * r, slope = 0.5 * r * r * r;
        for (int c = 0; c < 3; ++c) {
            const DoubleX4 w = weight[c][block];
            sums[c][0] += w * value;
            sums[c][1] += w * slope * t * t;
            sums[c][2] += w * slope * t;
            sums[c][3] += w * slope;
        }
    }
    // Neighbours first, unlike Sum: the tables' last bits hang on the order.
    const auto total = [](const DoubleX4 &s) { return (s[0] + s[1]) + (s[2] + s[3]); };
    Trial trial{p, {}, {}, 0};
    for (int c = 0; c < 3; ++c) {
        trial.residual[c] = total(sums[c][0]) - rgb[c];
        trial.jacobian[c] = {total(sums[c][1]), total(sums[c][2]), total(sums[c][3])};
    }
    trial.error = SquaredNorm(trial.residual);
    return trial;
}

SigmoidFit::Result SigmoidFit::Fit(const Triple &rgb, const SigmoidParameters &start) const {
    const double enough = Sqr(1e-5 * std::max({rgb[0], rgb[1], rgb[2]}));
    Trial best = Try(start, rgb);
    double damping = 1e-4;
    int stalled = 0;  // colours out of reach are approached ever slower
    for (int i = 0; i < 60 && best.error > enough && damping < 1e8 && stalled < 2; ++i) {
        const Trial next = Try(best.Next(damping), rgb);
        if (next.error < best.error) {
            stalled = next.error > 0.99 * best.error ? stalled + 1 : 0;
            best = next;
            damping *= 0.1;
        } else {
            damping *= 10;
        }
    }
    return {best.p, std::sqrt(best.error)};
}

SigmoidFit::Result SigmoidFit::Fit(const Triple &rgb) const {
    const double grey = (rgb[0] + rgb[1] + rgb[2]) / 3;
    return Fit(rgb, {0, 0, (grey - 0.5) / std::sqrt(grey * (1 - grey))});
}

}  // namespace pbrt
