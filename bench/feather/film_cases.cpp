#include <complex>
#include <numeric>

#include "bench/feather/cases.h"
#include "bench/feather/model.h"

namespace pbrt::bench {
namespace {

constexpr float kThickness = 590, kEta = 1.55f;
constexpr int N = NSpectrumSamples;

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
    for (const Input &in : MakeInputs(100000, 4)) {
        const float lambda = 360 + 470 * in.u.x, thickness = 2000 * in.u.y, eta = 1.3f + in.uc / 2;
        const float c = std::max(0.01f, in.wo.z);
        const double exact = feather::Film<double>({lambda}, {thickness}, eta).Reflectance(c);
        most = std::max(most, std::abs(reflectance(lambda, thickness, eta, c) - exact));
    }
    return most;
}

template <typename T>
Case SeriesCase(const std::string &name) {
    Case c;
    c.row.name = name;
    c.row.filmError = LargestError([](float lambda, float thickness, float eta, float cosine) {
        return SeriesReflectance<T>(lambda, thickness, eta, cosine);
    });
    c.timers.push_back({&Row::f, Pass([](const Input &in) {
                            std::array<T, N> R;
                            for (int i = 0; i < N; ++i)
                                R[i] = SeriesReflectance<T>(kLambda[i], kThickness, kEta, in.wo.z);
                            return float(std::accumulate(R.begin(), R.end(), T(0)));
                        })});
    return c;
}

}  // namespace

std::vector<Case> FilmCases() {
    Case real;
    real.row.name = "film, real numbers";
    real.row.filmError = LargestError([](float lambda, float thickness, float eta, float c) {
        return feather::Film<float>({lambda}, {thickness}, eta).Reflectance(c);
    });
    std::array<feather::Film<float>, N> films;
    for (int i = 0; i < N; ++i)
        films[i] = feather::Film<float>({kLambda[i]}, {kThickness}, kEta);
    real.timers.push_back({&Row::f, Pass([films](const Input &in) {
                               std::array<float, N> R;
                               for (int i = 0; i < N; ++i)
                                   R[i] = films[i].ReflectanceIf<false>(in.wo.z);  // as f does
                               return std::accumulate(R.begin(), R.end(), 0.f);
                           })});
    return {real, SeriesCase<float>("film, complex series"),
            SeriesCase<double>("film, series in double")};
}

}  // namespace pbrt::bench
