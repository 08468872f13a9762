#include "pbrt/textures/texture.h"

#include <fmt/format.h>

#include <algorithm>

#include "pbrt/textures/texture_builder.h"

namespace pbrt {
namespace {

template <typename Map>
std::string NearestIn(const Map &textures, std::string_view name) {
    std::vector<std::string_view> names;
    for (const auto &entry : textures)
        names.push_back(entry.first);
    return DidYouMean(name, names);
}

/// Reports why no texture of this name can be used for `parameter`.
void ReportUnknown(ParamDict &params, const NamedTextures &named, std::string_view parameter,
                   const std::string &name, bool wantsFloat) {
    // Unbounded is the one role that every spectrum texture has.
    const bool isFloat = named.floats.contains(name), isSpectrum = named.unboundeds.contains(name);
    std::string why;
    if (wantsFloat && isSpectrum)
        why = fmt::format("\"{}\" wants a float texture, but \"{}\" is a spectrum texture",
                          parameter, name);
    else if (!wantsFloat && isSpectrum)
        why =
            fmt::format("\"{}\" wants values in [0, 1], but texture \"{}\" has RGB values above 1",
                        parameter, name);
    else if (!wantsFloat && isFloat)
        why = fmt::format("\"{}\" wants a spectrum texture, but \"{}\" is a float texture",
                          parameter, name);
    else
        why = fmt::format(
            "no {} texture \"{}\" is defined before its use here{}",
            wantsFloat ? "float" : "spectrum", name,
            wantsFloat ? NearestIn(named.floats, name) : NearestIn(named.unboundeds, name));
    params.Error(parameter, why);
}

/// Where `"texture name"` was given: the texture, or `fallback` after an error.
template <typename Texture>
std::optional<Texture> FindNamed(ParamDict &params, const NamedTextures &named,
                                 const std::map<std::string, Texture> &textures,
                                 const ParamRow &row, bool wantsFloat, const Texture &fallback) {
    const std::optional<std::string> name = params.GetTexture(row);
    if (!name) return std::nullopt;
    const auto found = textures.find(*name);
    if (found != textures.end()) return found->second;
    ReportUnknown(params, named, NameOf(row), *name, wantsFloat);
    return fallback;
}

}  // namespace

bool NamedTextures::AnyReadsUV(const ParsedParameters &params) const {
    return std::any_of(params.begin(), params.end(), [&](const ParsedParameter &p) {
        return p.type == "texture" && !p.strings.empty() && readUV.contains(p.strings[0]);
    });
}

FloatTexture GetFloatTexture(ParamDict &params, const NamedTextures &named, const FloatParam &row) {
    std::optional<FloatTexture> texture =
        FindNamed(params, named, named.floats, row, true, FloatTexture(row.def));
    if (!texture) return params.GetOneFloat(row);
    if (texture->IsConstant() &&
        !(texture->Constant() >= row.lo && texture->Constant() <= row.hi)) {
        params.Error(
            row.name,
            fmt::format("\"{}\" must lie in [{}, {}]{}{}, but its texture is {} everywhere",
                        row.name, row.lo, row.hi, row.unit.empty() ? "" : " ", row.unit,
                        texture->Constant()));
        return row.def;
    }
    return *texture;
}

std::optional<SpectrumTexture> FindSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                                   const SpectrumParam &row) {
    std::optional<SpectrumTexture> texture = FindNamed(params, named, named.Spectra(row.role), row,
                                                       false, SpectrumTexture(Spectrum(0.5f)));
    if (texture) return texture;
    std::optional<Spectrum> value = params.GetOneSpectrum(row);
    if (!value) return std::nullopt;
    return SpectrumTexture(std::move(*value));
}

SpectrumTexture GetSpectrumTexture(ParamDict &params, const NamedTextures &named,
                                   const SpectrumParam &row) {
    std::optional<SpectrumTexture> given = FindSpectrumTexture(params, named, row);
    return given ? *std::move(given) : SpectrumTexture(DefaultSpectrum(row));
}

SpectrumByRole TextureBuilder::Spectra(SpectrumParam row) {
    SpectrumByRole made;
    if (const std::optional<std::string> texture = params.GetTexture(row)) {
        for (SpectrumType role : kSpectrumRoles) {
            const auto &known = named.Spectra(role);
            if (const auto found = known.find(*texture); found != known.end())
                made[size_t(role)] = found->second;
        }
        if (!made[size_t(SpectrumType::Unbounded)]) {
            ReportUnknown(params, named, row.name, *texture, false);
            made.fill(SpectrumTexture(DefaultSpectrum(row)));
        }
        return made;
    }
    const std::optional<RGB> rgb = params.GetOneRGB(row);
    for (SpectrumType role : kSpectrumRoles) {
        if (role == SpectrumType::Albedo && rgb && rgb->Max() > 1) continue;
        row.role = role;
        made[size_t(role)] = params.GetOneSpectrum(row).value_or(DefaultSpectrum(row));
    }
    return made;
}

}  // namespace pbrt
