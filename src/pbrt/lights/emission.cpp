#include "pbrt/lights/emission.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

constexpr FloatParam kScale{"scale", "", 1, 0, kOpen, "factor on what is emitted"};

Emission Normalized(const Spectrum &s, float photometric) {
    auto spectrum = std::make_shared<const Spectrum>(s.Scaled(1 / photometric));
    const float luminance = SpectrumToPhotometric(*spectrum);
    return {std::move(spectrum), luminance};
}

}  // namespace

Emission GetEmission(ParamDict &params, const SpectrumParam &row) {
    const Spectrum &illuminant = params.ColorSpace().Illuminant();
    const bool isRGB = params.GetOneRGB(row).has_value();
    const std::optional<Spectrum> given = params.GetOneSpectrum(row);
    const float ofIlluminant = SpectrumToPhotometric(illuminant);
    if (!given) return Normalized(illuminant, ofIlluminant);
    // Many lights' sigmoids share a table that stays in a core's cache; tables of their own would
    // not.
    if (isRGB) return Normalized(*given, ofIlluminant);
    const float photometric = SpectrumToPhotometric(*given);
    if (photometric > 0)
        return Normalized(given->IsConstant() ? *given : given->Densely(), photometric);
    params.Error(row.name, fmt::format("\"{}\" has no visible light: its level is set by `scale`, "
                                       "its shape must not be 0 from 360 to 830 nm",
                                       row.name));
    return Normalized(illuminant, ofIlluminant);
}

EmissionScale GetScale(ParamDict &params, const FloatParam &target) {
    return {params.GetOneFloat(kScale), params.GetOneFloat(target)};
}

}  // namespace pbrt
