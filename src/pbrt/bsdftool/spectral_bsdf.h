#pragma once

#include <array>
#include <vector>

#include "pbrt/bsdftool/material_source.h"

namespace pbrt::bsdftool {

/// A material's BSDFs at any number of wavelengths: four by four as the renderer carries them, or
/// one by one where the material ends the secondary wavelengths.
template <typename B>
struct SpectralBSDF {
    struct Part {
        B bsdf;
        size_t first, count;  ///< its wavelengths; further lanes repeat the last
    };
    std::vector<Part> parts;
};

inline SampledWavelengths GroupOf(const std::vector<float> &lambda, size_t first, size_t count) {
    std::array<float, NSpectrumSamples> group;
    for (size_t k = 0; k < group.size(); ++k)
        group[k] = lambda[first + std::min(k, count - 1)];
    return SampledWavelengths::Of(group);
}

template <typename M>
auto SpectralBSDFOf(const M &material, const std::vector<float> &lambda) {
    const TextureEvalContext ctx = MiddleOfTexture();
    const auto make = [&](SampledWavelengths &group) { return material.GetBxDF(ctx, group); };
    SpectralBSDF<decltype(make(std::declval<SampledWavelengths &>()))> spectral;
    for (size_t i = 0; i < lambda.size();) {
        size_t count = std::min(lambda.size() - i, size_t(NSpectrumSamples));
        SampledWavelengths group = GroupOf(lambda, i, count);
        auto bsdf = make(group);
        if (group.SecondaryTerminated() && count > 1) {
            count = 1;
            group = GroupOf(lambda, i, count);
            bsdf = make(group);
        }
        spectral.parts.push_back({bsdf, i, count});
        i += count;
    }
    return spectral;
}

/// Calls visit with the material's SpectralBSDF.
template <typename F>
decltype(auto) WithSpectralBSDF(const Material &material, const std::vector<float> &lambda,
                                F &&visit) {
    return std::visit([&](const auto &m) { return visit(SpectralBSDFOf(m, lambda)); }, material);
}

/// True for the BSDF that tells its R and TRT apart and has gaps.
template <typename B>
inline constexpr bool kIsFeather = std::is_same_v<B, FeatherBarbuleBxDF>;

}  // namespace pbrt::bsdftool
