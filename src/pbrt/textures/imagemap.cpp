#include "pbrt/textures/imagemap.h"

#include <fmt/format.h>

#include "pbrt/textures/color_role.h"
#include "pbrt/textures/encoding.h"
#include "pbrt/util/memory.h"

namespace pbrt {
namespace {

constexpr std::array<std::string_view, 5> kFilters{"point", "bilinear", "trilinear", "ewa", "EWA"};
constexpr std::array<std::string_view, 3> kWraps{"repeat", "black", "clamp"};
constexpr StringParam kFileName{"filename", "", "the picture"};
constexpr ChoiceParam kFilter{"filter", kFilters[1], kFilters, "how pixels become one value"};
constexpr ChoiceParam kWrap{"wrap", kWraps[0], kWraps, "what lies beyond the picture's border"};
constexpr FloatParam kAnisotropy{
    "maxanisotropy", "", 8, 1, 1000, "longest over shortest axis of an EWA ellipse, at most"};
constexpr FloatParam kScale{"scale", "", 1, -kOpen, kOpen, "factor on the picture's values"};
constexpr BoolParam kInvert{"invert", false, "values are taken from 1, after scale"};

/// Everything both kinds of image texture share.
struct ImageLookup {
    std::shared_ptr<const MIPMap> image;
    TextureMapping2D mapping;
    TextureSampling sampling;
    float scale = 1;
    bool invert = false;

    template <typename T>
    T Stored(const TextureEvalContext &ctx) const {
        const TexCoord2D c = mapping.Map(ctx);
        // Rows of images run downwards.
        return image->Lookup<T>({c.st.x, 1 - c.st.y}, {c.dsdx, -c.dtdx, c.dsdy, -c.dtdy}, sampling);
    }
    float Adjusted(float v) const {
        v *= scale;
        return std::max(0.f, invert ? 1 - v : v);
    }
};

struct FloatImage : FloatNode {
    explicit FloatImage(ImageLookup lookup) : lookup(std::move(lookup)) {}
    float Evaluate(const TextureEvalContext &ctx) const override {
        return lookup.Adjusted(lookup.Stored<float>(ctx));
    }
    ImageLookup lookup;
};

struct SpectrumImage : SpectrumNode {
    SpectrumImage(ImageLookup lookup, SpectrumType role) : lookup(std::move(lookup)), role(role) {}
    SampledSpectrum Evaluate(const TextureEvalContext &ctx,
                             const SampledWavelengths &lambda) const override {
        const RGBColorSpace &space = lookup.image->ColorSpace();
        if (lookup.image->NChannels() == 1)
            return SampleGrey(space, lookup.Adjusted(lookup.Stored<float>(ctx)), role, lambda);
        const RGB rgb = lookup.Stored<RGB>(ctx);
        return SampleColor(space,
                           {lookup.Adjusted(rgb.r), lookup.Adjusted(rgb.g), lookup.Adjusted(rgb.b)},
                           role, lambda);
    }
    ImageLookup lookup;
    SpectrumType role;
};

using Images = decltype(NamedTextures::images);

std::string AlphaKey(const std::string &key) {
    return key + "|A";
}

/// The image among those already read; nullopt where none serves.
std::optional<std::shared_ptr<const MIPMap>> FindImage(const Images &images, const std::string &key,
                                                       bool wantsFloat) {
    const auto color = images.find(key);
    if (color != images.end() && !(wantsFloat && color->second && color->second->LeavesOutAlpha()))
        return color->second;
    const auto alpha = images.find(AlphaKey(key));
    if (wantsFloat && alpha != images.end()) return alpha->second;
    return std::nullopt;
}

/// Adds the file's colour, or the alpha that floats are read from; nullptr after an error.
std::shared_ptr<const MIPMap> AddImage(ParamDict &params, const std::string &file,
                                       const std::optional<ColorEncoding> &encoding,
                                       bool wantsFloat, const std::string &key, Images &images) {
    const OrError<Image> read = ReadImage(file, encoding);
    if (!read) {
        params.Error(kFileName.name, read.error);
        return images[key] = nullptr;
    }
    const Image &image = *read.value;
    if (!image.metadata.unread.empty())
        params.WarningOnce(kFileName.name, fmt::format("{}: {}", file, image.metadata.unread));
    if (const auto why = WhyTooLarge(MIPMap::BytesToCreate(image))) {
        params.Error(kFileName.name, fmt::format("\"{}\" as a texture {}", file, *why));
        return images[key] = nullptr;
    }
    if (wantsFloat && MIPMap::HasAlpha(image))
        return images[AlphaKey(key)] = MIPMap::CreateOfAlpha(image);
    const std::shared_ptr<const MIPMap> map =
        MIPMap::Create(image, encoding.value_or(ColorEncoding{ColorEncoding::Kind::sRGB, 1}));
    if (!map)
        params.Error(kFileName.name,
                     fmt::format("\"{}\" has no channels R, G, B nor Y to make a texture of; it "
                                 "has {}",
                                 file, fmt::join(image.ChannelNames(), ", ")));
    return images[key] = map;
}

/// The image, or what floats are read from; nullptr after an error.
std::shared_ptr<const MIPMap> GetImage(TextureBuilder &builder, bool wantsFloat) {
    ParamDict &params = builder.params;
    const std::string file = params.GetFileName(kFileName);
    const std::optional<ColorEncoding> encoding = GetEncoding(params);
    if (file.empty()) {
        params.Error(
            kFileName.name,
            fmt::format("{} needs \"string filename\", a picture's file name", params.What()));
        return nullptr;
    }
    const std::string key = fmt::format(
        "{}|{}", file, encoding ? fmt::format("{} {}", int(encoding->kind), encoding->gamma) : "");
    Images &images = builder.named.images;
    if (const auto known = FindImage(images, key, wantsFloat)) return *known;
    return AddImage(params, file, encoding, wantsFloat, key, images);
}

std::optional<ImageLookup> CreateLookup(TextureBuilder &builder, bool wantsFloat) {
    ParamDict &params = builder.params;
    ImageLookup lookup;
    lookup.mapping = TextureMapping2D::Create(params, builder.textureFromRender);
    builder.readsUV |= lookup.mapping.ReadsUV();
    const int filter = params.GetOneChoice(kFilter);
    lookup.sampling.filter = TextureFilter(std::min(filter, int(TextureFilter::EWA)));
    lookup.sampling.wrap = WrapMode(params.GetOneChoice(kWrap));
    lookup.sampling.maxAnisotropy = params.GetOneFloat(kAnisotropy);
    lookup.scale = params.GetOneFloat(kScale);
    lookup.invert = params.GetOneBool(kInvert);
    lookup.image = GetImage(builder, wantsFloat);
    if (!lookup.image) return std::nullopt;
    builder.named.readFootprints |= lookup.image->NLevels() > 1;
    return lookup;
}

}  // namespace

FloatTexture ImageTexture::CreateFloat(TextureBuilder &builder) {
    const std::optional<ImageLookup> lookup = CreateLookup(builder, true);
    if (!lookup) return 1.f;
    return FloatTexture(std::make_shared<FloatImage>(*lookup));
}

SpectrumByRole ImageTexture::CreateSpectrum(TextureBuilder &builder) {
    const std::optional<ImageLookup> lookup = CreateLookup(builder, false);
    SpectrumByRole made;
    for (SpectrumType role : kSpectrumRoles) {
        if (lookup)
            made[size_t(role)] = SpectrumTexture(std::make_shared<SpectrumImage>(*lookup, role));
        else
            made[size_t(role)] = SpectrumTexture(Spectrum(1.f));
    }
    return made;
}

}  // namespace pbrt
