#include <complex>

#include "pbrt/bsdftool/bench_cases.h"
#include "pbrt/bsdftool/bench_model.h"

namespace pbrt::bsdftool {
namespace {

constexpr float kLambda = 550, kThickness = 590, kEta = 1.55f;

/// S-eq.1 as it stands, unpolarised.
template <typename T>
T SeriesReflectance(T lambda, T thickness, T eta, T c) {
    const T inside = std::sqrt(1 - (1 - c * c) / (eta * eta));
    const std::complex<T> turn =
        std::polar(T(1), 4 * std::numbers::pi_v<T> * thickness * eta * inside / lambda);
    const auto power = [&](T outer, T inner) {
        const T r = (outer - inner) / (outer + inner), tt = 1 - r * r;
        return std::norm(r - tt * r * turn / (T(1) - r * r * turn));
    };
    return (power(c, eta * inside) + power(eta * c, inside)) / 2;
}

/// The largest error over films up to 2 um and angles up to 89.4 degrees.
template <typename Reflectance>
double LargestError(const Reflectance &reflectance) {
    double most = 0;
    for (const BenchInput &in : BenchInputs(100000, 4)) {
        const float lambda = 360 + 470 * in.u.x, thickness = 2000 * in.u.y, eta = 1.3f + in.uc / 2;
        const float c = std::max(0.01f, in.wo.z);
        const double exact = feather::Film<double>({lambda}, {thickness}, eta).Reflectance(c);
        most = std::max(most, std::abs(reflectance(lambda, thickness, eta, c) - exact));
    }
    return most;
}

}  // namespace

std::vector<BenchCase> FilmCases() {
    BenchCase real, series;
    real.row.name = "film, real numbers";
    real.row.filmError = LargestError([](float lambda, float thickness, float eta, float c) {
        return feather::Film<float>({lambda}, {thickness}, eta).Reflectance(c);
    });
    const feather::Film<float> film({kLambda}, {kThickness}, kEta);
    real.timers.push_back(
        {&BenchRow::f, Pass([film](const BenchInput &in) { return film.Reflectance(in.wo.z); })});
    series.row.name = "film, complex series";
    series.row.filmError = LargestError(SeriesReflectance<float>);
    series.timers.push_back({&BenchRow::f, Pass([](const BenchInput &in) {
                                 return SeriesReflectance(kLambda, kThickness, kEta, in.wo.z);
                             })});
    return {real, series};
}

}  // namespace pbrt::bsdftool
