#include "pbrt/films/spectral.h"

#include <fmt/format.h>

#include <algorithm>

namespace pbrt {
namespace {

constexpr IntParam kNBuckets{"nbuckets", 16, 1, 4096, "channels, equally wide"};
constexpr FloatParam kMin{"lambdamin", "nm",      LambdaMin,
                          LambdaMin,   LambdaMax, "where the first bucket begins"};
constexpr FloatParam kMax{"lambdamax", "nm",      LambdaMax,
                          LambdaMin,   LambdaMax, "where the last bucket ends"};

}  // namespace

SpectralFilm SpectralFilm::Create(ParamDict &params) {
    SpectralFilm b;
    b.n = size_t(params.GetOneInt(kNBuckets));
    const float least = params.GetOneFloat(kMin), most = params.GetOneFloat(kMax);
    if (least < most)
        b.lambdaMin = least, b.lambdaMax = most;
    else
        params.Error("lambdamin", "\"lambdamin\" must be less than \"lambdamax\"");
    return b;
}

void SpectralFilm::Add(Sums *sums, const FilmSample &sample) const {
    const SampledSpectrum pdf = sample.lambda.PDF();
    for (int i = 0; i < NSpectrumSamples; ++i) {
        if (pdf[i] == 0) continue;
        // Where a path ended its other wavelengths, the one that is left stands for all.
        const double share = double(sample.weight) / pdf[i];
        const size_t b = size_t(BucketOf(sample.lambda[i]));
        sums->values[b] += share * sample.exposed[i];
        sums->weights[b] += share;
    }
}

std::vector<std::string> SpectralFilm::ChannelNames() const {
    std::vector<std::string> names;
    for (size_t i = 0; i < n; ++i) {
        std::string middle = fmt::format(
            "{:.3f}", lambdaMin + (double(lambdaMax) - lambdaMin) * (double(i) + 0.5) / double(n));
        std::replace(middle.begin(), middle.end(), '.', ',');
        names.push_back("S0." + middle + "nm");
    }
    return names;
}

void SpectralFilm::Write(const Sums &sums, float *channels) const {
    for (size_t i = 0; i < n; ++i) {
        const double weight = sums.weights[i].Value();
        channels[i] = weight == 0 ? 0 : float(sums.values[i].Value() / weight);
    }
}

void SpectralFilm::WriteMetadata(std::map<std::string, std::string> *strings) const {
    strings->insert({{"spectralLayoutVersion", "1.0"}, {"emissiveUnits", "W.m^-2.sr^-1"}});
}

}  // namespace pbrt
