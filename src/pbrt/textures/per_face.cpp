#include "pbrt/textures/per_face.h"

#include <fmt/format.h>

#include "pbrt/ptex/texture.h"
#include "pbrt/textures/color_role.h"
#include "pbrt/textures/encoding.h"

namespace pbrt {
namespace {

constexpr StringParam kFileName{"filename", "", "the Ptex file"};
constexpr FloatParam kScale{"scale", "", 1, -kOpen, kOpen, "factor on the file's values"};

/// Everything both kinds of texture share.
struct FaceLookup {
    std::shared_ptr<const PtexTexture> file;
    ColorEncoding encoding;
    float scale = 1;

    bool IsGrey() const { return file->NChannels() < 3; }
    template <size_t N>
    std::array<float, N> Values(const TextureEvalContext &ctx) const {
        std::array<float, N> values;
        const Vector2f width{std::abs(ctx.dudx) + std::abs(ctx.dudy),
                             std::abs(ctx.dvdx) + std::abs(ctx.dvdy)};
        file->Lookup(ctx.faceIndex, ctx.uv, width, values);
        for (float &v : values)
            v = scale * encoding.ToLinear(v);
        return values;
    }
    RGB Color(const TextureEvalContext &ctx) const {
        const std::array<float, 3> v = Values<3>(ctx);
        return {std::max(0.f, v[0]), std::max(0.f, v[1]), std::max(0.f, v[2])};
    }
};

struct FloatFaces : FloatNode {
    explicit FloatFaces(FaceLookup lookup) : lookup(std::move(lookup)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        if (lookup.IsGrey()) return lookup.Values<1>(ctx)[0];
        const std::array<float, 3> v = lookup.Values<3>(ctx);
        return (v[0] + v[1] + v[2]) * (1 / 3.f);
    }
    FaceLookup lookup;
};

struct SpectrumFaces : SpectrumNode {
    SpectrumFaces(FaceLookup lookup, SpectrumType role) : lookup(std::move(lookup)), role(role) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        const RGBColorSpace &space = RGBColorSpace::sRGB();
        if (lookup.IsGrey())
            return SampleGrey(space, std::max(0.f, lookup.Values<1>(ctx)[0]), role, lambda);
        return SampleColor(space, lookup.Color(ctx), role, lambda);
    }
    FaceLookup lookup;
    SpectrumType role;
};

/// The file, from those already read; nullptr after an error.
std::shared_ptr<const PtexTexture> GetFile(TextureBuilder &builder) {
    ParamDict &params = builder.params;
    const std::string name = params.GetFileName(kFileName);
    if (name.empty()) {
        params.Error(kFileName.name, fmt::format("{} needs \"string filename\", a Ptex file's name",
                                                 params.What()));
        return nullptr;
    }
    const auto [known, isNew] = builder.named.faceFiles.try_emplace(name);
    if (!isNew) return known->second;
    OrError<PtexData> data = ReadPtex(name);
    if (!data)
        params.Error(kFileName.name, data.error);
    else
        known->second = std::make_shared<const PtexTexture>(std::move(*data.value));
    return known->second;
}

std::optional<FaceLookup> CreateLookup(TextureBuilder &builder) {
    constexpr ColorEncoding kDefault{ColorEncoding::Kind::Gamma, 2.2f};
    FaceLookup lookup;
    lookup.encoding = GetEncoding(builder.params).value_or(kDefault);
    lookup.scale = builder.params.GetOneFloat(kScale);
    lookup.file = GetFile(builder);
    if (!lookup.file) return {};
    builder.named.readFootprints |= !lookup.file->IsFlat();
    return lookup;
}

}  // namespace

FloatTexture PerFaceTexture::CreateFloat(TextureBuilder &builder) {
    const std::optional<FaceLookup> lookup = CreateLookup(builder);
    if (!lookup) return 1.f;
    return FloatTexture(std::make_shared<FloatFaces>(*lookup));
}

SpectrumByRole PerFaceTexture::CreateSpectrum(TextureBuilder &builder) {
    const std::optional<FaceLookup> lookup = CreateLookup(builder);
    SpectrumByRole made;
    for (const SpectrumType role : kSpectrumRoles)
        made[size_t(role)] = lookup
                                 ? SpectrumTexture(std::make_shared<SpectrumFaces>(*lookup, role))
                                 : SpectrumTexture(Spectrum(1.f));
    return made;
}

}  // namespace pbrt
