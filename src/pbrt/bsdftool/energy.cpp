#include "pbrt/bsdftool/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "pbrt/bsdftool/spectral_bsdf.h"
#include "pbrt/util/rng.h"

namespace pbrt::bsdftool {
namespace {

constexpr int kShifts = 8;

struct SampleNumbers {
    float uc;
    Point2f u;
};

/// The points of all shifts, one shift after the other.
std::vector<SampleNumbers> Points(int samples) {
    // Powers of 1/g, g^4 = g + 1: the additive recurrence of best known evenness in 3 dimensions.
    constexpr std::array<double, 3> step{0.8191725133961645, 0.6710436067037893,
                                         0.5497004779019703};
    Rng rng(1);
    std::vector<SampleNumbers> points;
    for (int shift = 0; shift < kShifts; ++shift) {
        const std::array<double, 3> start{rng.Uniform(), rng.Uniform(), rng.Uniform()};
        for (int i = 0; i < samples / kShifts; ++i) {
            const auto number = [&](int d) {
                return std::min(float(std::fmod(start[d] + (i + 0.5) * step[d], 1)),
                                OneMinusEpsilon);
            };
            points.push_back({number(0), {number(1), number(2)}});
        }
    }
    return points;
}

/// Adds what one sample brings, weighted; returns the mean over wavelengths of what it reflects.
template <typename Part>
double AddSample(const Part &part, Vector3f wo, const SampleNumbers &numbers, double share,
                 Albedo &energy) {
    // Importance: light that enters, so that refraction does not scale it.
    const auto s = part.bsdf.Sample_f(wo, numbers.uc, numbers.u, TransportMode::Importance);
    if (!s) return 0;
    const double weight = share * std::abs(s->wi.z) / s->pdf;
    if (Has(s->flags, BxDFFlags::NullTransmission)) {
        energy.gap += s->f[0] * weight * double(part.count);
        return 0;
    }
    const bool back = SameHemisphere(wo, s->wi);
    auto &side = back ? energy.reflected : energy.transmitted;
    double sum = 0;
    for (size_t k = 0; k < part.count; ++k) {
        side[part.first + k] += s->f[int(k)] * weight;
        sum += s->f[int(k)] * weight / share;
    }
    if constexpr (kIsFeather<decltype(part.bsdf)>) {
        const auto parts = part.bsdf.Lobes(wo, s->wi);
        for (size_t k = 0; k < part.count; ++k) {
            energy.R[part.first + k] += parts.R[int(k)] * weight;
            energy.TRT[part.first + k] += parts.TRT[int(k)] * weight;
        }
    }
    return back ? sum : 0;
}

double StandardError(const std::array<double, kShifts> &means) {
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / kShifts;
    double variance = 0;
    for (double m : means)
        variance += (m - mean) * (m - mean) / (kShifts - 1);
    return std::sqrt(variance / kShifts);
}

}  // namespace

double Albedo::Mean(const std::vector<double> &shares) {
    if (shares.empty()) return 0;
    return std::accumulate(shares.begin(), shares.end(), 0.0) / double(shares.size());
}

Albedo AlbedoFrom(const Material &material, const LocalDirection &wo,
                  const std::vector<float> &lambda, int samples) {
    const std::vector<SampleNumbers> points = Points(samples);
    const double share = 1.0 / double(points.size());
    return WithSpectralBSDF(material, lambda, [&](const auto &spectral) {
        Albedo energy;
        const std::vector<double> none(lambda.size(), 0.0);
        energy.reflected = energy.transmitted = none;
        if (kIsFeather<decltype(spectral.parts[0].bsdf)>) energy.R = energy.TRT = none;
        std::array<double, kShifts> reflected{};
        for (const auto &part : spectral.parts)
            for (size_t i = 0; i < points.size(); ++i)
                reflected[i * kShifts / points.size()] +=
                    AddSample(part, wo.ToFloat(), points[i], share, energy) * share * kShifts /
                    double(lambda.size());
        energy.gap /= double(lambda.size());
        energy.error = StandardError(reflected);
        return energy;
    });
}

std::vector<float> MiddleWavelengths(int count) {
    std::vector<float> lambda;
    for (int i = 0; i < count; ++i)
        lambda.push_back(LambdaMin + (LambdaMax - LambdaMin) * (float(i) + 0.5f) / float(count));
    return lambda;
}

}  // namespace pbrt::bsdftool
