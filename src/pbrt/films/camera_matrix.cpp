#include "pbrt/films/camera_matrix.h"

#include <vector>

namespace pbrt {
namespace {

/// A table of equal steps as a spectrum, 0 beyond.
template <size_t N>
Spectrum Tabulated(const std::array<float, N> &values, float first, float step) {
    std::vector<float> lambda;
    for (size_t i = 0; i < N; ++i)
        lambda.push_back(first + step * float(i));
    return Spectrum::PiecewiseLinear(lambda, values);
}

/// Sum over whole nm of the product of two or three spectra.
template <typename... S>
double Integral(const S &...spectra) {
    double sum = 0;
    for (float lambda = LambdaMin; lambda <= LambdaMax; ++lambda)
        sum += (double(spectra(lambda)) * ...);
    return sum;
}

using Triple = std::array<double, 3>;

/// Response of three curves to a reflectance under a light, in units of what the second of them
/// sees of the light itself.
Triple Seen(const Spectrum &reflectance, const Spectrum &light,
            const std::array<Spectrum, 3> &curves) {
    const double white = Integral(light, curves[1]);
    Triple seen;
    for (size_t c = 0; c < 3; ++c)
        seen[c] = Integral(reflectance, light, curves[c]) / white;
    return seen;
}

}  // namespace

std::array<Spectrum, 3> CurvesOf(const CameraCurves &camera) {
    std::array<Spectrum, 3> curves;
    for (size_t c = 0; c < 3; ++c)
        curves[c] = Tabulated(camera.rgb[c], CameraCurves::kFirst, CameraCurves::kStep);
    return curves;
}

Matrix3d XYZFromCamera(const CameraCurves &camera, const Spectrum &light,
                       const RGBColorSpace &space) {
    const std::array<Spectrum, 3> curves = CurvesOf(camera),
                                  observer{spectra::X(), spectra::Y(), spectra::Z()};
    // Normal equations: M (sum of c c^T) = sum of x c^T over the patches' camera and XYZ values.
    Matrix3d cc{}, xc{};
    for (const ColorCheckerPatch &patch : ColorChecker()) {
        const Spectrum reflectance =
            Tabulated(patch.reflectance, ColorCheckerPatch::kFirst, ColorCheckerPatch::kStep);
        const Triple c = Seen(reflectance, light, curves),
                     x = Seen(reflectance, space.Illuminant(), observer);
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                cc[i][j] += c[i] * c[j];
                xc[i][j] += x[i] * c[j];
            }
    }
    Matrix3d m = Product(xc, Inverse(cc));
    const double luminancePerGreen = Integral(light, observer[1]) / Integral(light, curves[1]);
    for (auto &row : m)
        for (double &entry : row)
            entry *= luminancePerGreen;
    return m;
}

}  // namespace pbrt
