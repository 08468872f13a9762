// Colours and spectra of ParamDict.

#include <fmt/format.h>

#include <charconv>

#include "pbrt/scene/params.h"
#include "pbrt/scene/scene_file.h"
#include "pbrt/spectra/spectrum_file.h"
#include "pbrt/util/check.h"

namespace pbrt {
namespace {

/// True if 0 beyond an end that lies within visible light is another spectrum than the end's value.
bool EndsMatter(const SpectrumPoints &points) {
    return (points.lambda.front() > LambdaMin && points.values.front() != 0) ||
           (points.lambda.back() < LambdaMax && points.values.back() != 0);
}

}  // namespace

Spectrum DefaultSpectrum(const SpectrumParam &row) {
    float constant = 0;
    const char *const end = row.def.data() + row.def.size();
    const auto [stop, error] = std::from_chars(row.def.data(), end, constant);
    if (error == std::errc() && stop == end) return Spectrum(constant);
    const Spectrum *const named = GetNamedSpectrum(row.def);
    DCHECK(named);
    return *named;
}

std::optional<Spectrum> ParamDict::GetOneSpectrum(const SpectrumParam &row) {
    const ParsedParameter *const p = Find(row);
    if (!p) return {};
    if (p->type == "rgb") return FromRGB(*p, row.role);
    if (p->type == "blackbody") return FromBlackbody(*p);
    if (!p->strings.empty()) return FromNameOrFile(*p, row.role);
    return FromPairs(*p);
}

std::optional<Spectrum> ParamDict::FromRGB(const ParsedParameter &p, SpectrumType role) {
    const std::optional<RGB> rgb = CheckedRGB(p, role == SpectrumType::Albedo ? 1 : Infinity);
    if (!rgb) return {};
    const RGBColorSpace &space = p.colorSpace ? *p.colorSpace : *colorSpace;
    switch (role) {
        case SpectrumType::Albedo:
            return space.AlbedoSpectrum(*rgb);
        case SpectrumType::Unbounded:
            return space.UnboundedSpectrum(*rgb);
        case SpectrumType::Illuminant:
            return space.IlluminantSpectrum(*rgb);
    }
    return {};
}

std::optional<Spectrum> ParamDict::FromBlackbody(const ParsedParameter &p) {
    if (!CountIs(p, 1)) return {};
    if (p.floats[0] > 0) return Spectrum::Blackbody(p.floats[0]);
    ValueError(p, fmt::format("{} is not above 0 K", p.floats[0]));
    return {};
}

std::optional<Spectrum> ParamDict::FromPairs(const ParsedParameter &p) {
    if (p.floats.empty()) return {};
    if (p.floats.size() % 2 != 0) {
        ValueError(
            p, fmt::format("{} numbers are not pairs of wavelength and value", p.floats.size()));
        return {};
    }
    std::vector<float> lambda, values;
    for (size_t i = 0; i < p.floats.size(); i += 2) {
        if (i > 0 && p.floats[i] <= lambda.back()) {
            ValueError(p, fmt::format("wavelength {} nm follows {} nm; they must increase",
                                      p.floats[i], lambda.back()));
            return {};
        }
        lambda.push_back(p.floats[i]);
        values.push_back(p.floats[i + 1]);
    }
    if (lambda.size() == 1)
        diagnostics->Warning(p.valueLoc, fmt::format("\"spectrum {}\": one wavelength only; the "
                                                     "spectrum is 0 at all others",
                                                     p.name));
    return Spectrum::PiecewiseLinear(lambda, values);
}

std::optional<Spectrum> ParamDict::FromNameOrFile(const ParsedParameter &p, SpectrumType role) {
    if (!CountIs(p, 1)) return {};
    const std::string &name = p.strings[0];
    if (const Spectrum *named = GetNamedSpectrum(name)) return *named;
    OrError<SpectrumPoints> file = ReadSpectrumFile(ResolvePath(name, dir));
    if (file) {
        if (EndsMatter(*file.value))
            diagnostics->WarningOnce(
                p.valueLoc,
                fmt::format("\"{}\" covers {} to {} nm of {} to {}: outside, surfaces have its end "
                            "values and lights are dark",
                            name, file.value->lambda.front(), file.value->lambda.back(), LambdaMin,
                            LambdaMax));
        if (role != SpectrumType::Illuminant) *file.value = HoldingEnds(std::move(*file.value));
        return Spectrum::PiecewiseLinear(file.value->lambda, file.value->values);
    }
    ValueError(p, fmt::format("\"{}\" is no built-in spectrum, and as a file: {}{}", name,
                              file.error, DidYouMean(name, NamedSpectrumNames())));
    return {};
}

}  // namespace pbrt
