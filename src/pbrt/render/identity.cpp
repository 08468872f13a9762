#include "pbrt/render/identity.h"

#include <fmt/format.h>

namespace pbrt {
namespace {

/// The sampler's own seed, which outranks that of the options.
int SeedOf(const SceneDescription &description) {
    for (auto p = description.sampler.params.rbegin(); p != description.sampler.params.rend(); ++p)
        if (p->name == "seed" && p->ints.size() == 1) return p->ints[0];
    return description.options.seed;
}

/// Names in the scene that are no assets.
std::vector<std::string> WrittenFiles(const SceneDescription &description) {
    std::vector<std::string> names{description.options.mseReferenceOut};
    for (const ParsedParameter &p : description.film.params)
        if (p.name == "filename") names.insert(names.end(), p.strings.begin(), p.strings.end());
    return names;
}

std::string BoundsText(const PixelBounds &b) {
    return fmt::format("[{}, {}) x [{}, {})", b.x0, b.x1, b.y0, b.y1);
}

}  // namespace

Digest RenderIdentity::Scene() const {
    return Joined(Joined(text, assets), DigestOf(options));
}

std::optional<std::string> RenderIdentity::Difference(const RenderIdentity &other) const {
    if (version != other.version)
        return fmt::format("pbrt-feather {}, and this is {}", version, other.version);
    if (text != other.text) return "another scene (its text differs)";
    if (assets != other.assets)
        return "another scene (a file that it names, as a mesh or a texture, differs)";
    if (options != other.options)
        return fmt::format("other options ({}; now {})", options, other.options);
    if (seed != other.seed)
        return fmt::format("seed {}, and this render's is {}", seed, other.seed);
    if (spp != other.spp)
        return fmt::format("{} samples per pixel, and now {} are wanted", spp, other.spp);
    if (samples != other.samples)
        return fmt::format("the samples {}:{}, and now {}:{} are wanted", samples.first,
                           samples.last, other.samples.first, other.samples.last);
    if (!(pixels == other.pixels))
        return fmt::format("the pixels {}, and now {} are wanted", BoundsText(pixels),
                           BoundsText(other.pixels));
    if (film != other.film) return "another film";
    return {};
}

RenderIdentity IdentityOf(const SceneDescription &description, const Overrides &overrides) {
    const Options &o = description.options;
    RenderIdentity id;
    id.version = PBRT_VERSION;
    id.text = description.content.Text();
    id.assets = description.content.Assets(WrittenFiles(description));
    id.options = fmt::format("render-coord-sys {}", o.renderCoordSys);
    const auto flag = [&](bool set, std::string_view name) {
        if (set) id.options.append(", ").append(name);
    };
    flag(overrides.film.quick, "quick");
    flag(o.disablePixelJitter, "disable-pixel-jitter");
    flag(o.disableWavelengthJitter, "disable-wavelength-jitter");
    flag(o.disableTextureFiltering, "disable-texture-filtering");
    flag(o.forceDiffuse, "force-diffuse");
    if (overrides.targetError > 0)
        id.options += fmt::format(", target-error {}", overrides.targetError);
    id.seed = SeedOf(description);
    return id;
}

void Complete(const RenderTask &task, RenderIdentity *identity) {
    identity->spp = task.SamplesPerPixel();
    identity->samples = task.Samples();
    identity->pixels = task.scene->film.Bounds();
    identity->film = task.scene->film.TypeName();
}

Origin OriginOf(const RenderIdentity &identity) {
    return {ToText(identity.Scene()),
            {identity.seed},
            identity.samples.first,
            identity.samples.last,
            identity.spp};
}

}  // namespace pbrt
