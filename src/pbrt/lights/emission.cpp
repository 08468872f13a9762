#include "pbrt/lights/emission.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

Emission Normalized(const Spectrum &s, float photometric) {
    auto spectrum = std::make_shared<const Spectrum>(s.Scaled(1 / photometric));
    const float luminance = SpectrumToPhotometric(*spectrum);
    return {std::move(spectrum), luminance};
}

}  // namespace

Emission GetEmission(ParamDict &params, std::string_view name) {
    const Spectrum &illuminant = params.ColorSpace().Illuminant();
    const bool isRGB = params.Has(name, "rgb");
    const std::optional<Spectrum> given = params.GetOneSpectrum(name, SpectrumType::Illuminant);
    const float ofIlluminant = SpectrumToPhotometric(illuminant);
    if (!given) return Normalized(illuminant, ofIlluminant);
    // Many lights' sigmoids share a table that stays in a core's cache; tables of their own would
    // not.
    if (isRGB) return Normalized(*given, ofIlluminant);
    const float photometric = SpectrumToPhotometric(*given);
    if (photometric > 0)
        return Normalized(given->IsConstant() ? *given : given->Densely(), photometric);
    params.Error(name, fmt::format("\"{}\" has no visible light: its level is set by `scale`, its "
                                   "shape must not be 0 from 360 to 830 nm",
                                   name));
    return Normalized(illuminant, ofIlluminant);
}

EmissionScale GetScale(ParamDict &params, std::string_view target, std::string_view unit) {
    static constexpr FloatParam kScale{"scale", "", 1, 0, Infinity, "factor on what is emitted"};
    const FloatParam row{target, unit, -1, -1, Infinity, "amount to emit; not above 0: as L says"};
    return {params.GetOneFloat(kScale), params.GetOneFloat(row)};
}

}  // namespace pbrt
