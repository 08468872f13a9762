// What each directive reads (PBRT_FORMAT 1.3).

#include "pbrt/scene/directives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "pbrt/scene/option_directive.h"
#include "pbrt/scene/transform_directives.h"

namespace pbrt {
namespace {

// --- Settings of the whole image ---

void ReadAccelerator(DirectiveContext &c) {
    if (auto e = c.NamedEntity("accelerator", "the accelerator's name"))
        c.scene->accelerator = std::move(*e);
}
void ReadCamera(DirectiveContext &c) {
    if (auto e = c.NamedEntity("camera", "the camera's name")) c.builder.Camera(std::move(*e));
}
void ReadFilm(DirectiveContext &c) {
    if (auto e = c.NamedEntity("film", "the film's name")) c.scene->film = std::move(*e);
}
void ReadIntegrator(DirectiveContext &c) {
    if (auto e = c.NamedEntity("integrator", "the integrator's name"))
        c.scene->integrator = std::move(*e);
}
void ReadPixelFilter(DirectiveContext &c) {
    if (auto e = c.NamedEntity("filter", "the filter's name")) c.scene->filter = std::move(*e);
}
void ReadSampler(DirectiveContext &c) {
    if (auto e = c.NamedEntity("sampler", "the sampler's name")) c.scene->sampler = std::move(*e);
}

void ReadColorSpace(DirectiveContext &c) {
    const FileLoc loc = c.arguments.Loc();
    const std::optional<std::string> name = c.arguments.Name("the colour space's name");
    if (!name) return;
    if (const RGBColorSpace *space = RGBColorSpace::Named(*name))
        return c.builder.SetColorSpace(space);
    c.arguments.Error(
        loc, fmt::format("\"{}\" is not one of {}{}", *name, QuotedList(RGBColorSpace::Names()),
                         DidYouMean(*name, RGBColorSpace::Names())));
}

void ReadAttribute(DirectiveContext &c) {
    const FileLoc loc = c.arguments.Loc();
    const std::optional<std::string> name = c.arguments.Name("the target's name");
    if (!name) return;
    const auto target = std::find(kAttributeTargets.begin(), kAttributeTargets.end(), *name);
    const bool known = target != kAttributeTargets.end();
    if (!known)
        c.arguments.Error(
            loc, fmt::format("\"{}\" is not one of {}{}", *name, QuotedList(kAttributeTargets),
                             DidYouMean(*name, kAttributeTargets)));
    ParsedParameters list = c.arguments.Parameters(c.builder.ColorSpace());
    if (known)
        c.builder.AddAttribute(AttributeTarget(target - kAttributeTargets.begin()),
                               std::move(list));
}

void ReadReverseOrientation(DirectiveContext &c) {
    c.builder.ReverseOrientation();
}
void ReadWorldBegin(DirectiveContext &c) {
    if (c.builder.InWorld())
        return c.log->Error(c.arguments.At(),
                            fmt::format("a second WorldBegin; the first is at {}:{}:{}",
                                        c.worldBegin.file, c.worldBegin.line, c.worldBegin.column));
    c.worldBegin = c.arguments.At();
    c.builder.WorldBegin();
}

// --- Scopes ---

void ReadAttributeBegin(DirectiveContext &c) {
    c.builder.AttributeBegin(c.arguments.At());
}
void ReadAttributeEnd(DirectiveContext &c) {
    c.builder.AttributeEnd(c.arguments.At());
}
void ReadTransformBegin(DirectiveContext &c) {
    if (!c.saidTransformBegin)
        c.log->Warning(c.arguments.At(),
                       "TransformBegin and TransformEnd are read as AttributeBegin and "
                       "AttributeEnd: pbrt-v4 has only these");
    c.saidTransformBegin = true;
    ReadAttributeBegin(c);
}
void ReadTransformEnd(DirectiveContext &c) {
    ReadAttributeEnd(c);
}

void ReadObjectBegin(DirectiveContext &c) {
    const std::optional<std::string> name = c.arguments.Name("the object's name");
    c.builder.ObjectBegin(name.value_or(""), c.arguments.At());
}
void ReadObjectEnd(DirectiveContext &c) {
    c.builder.ObjectEnd(c.arguments.At());
}
void ReadObjectInstance(DirectiveContext &c) {
    if (const auto name = c.arguments.Name("the object's name"))
        c.builder.ObjectInstance(*name, c.arguments.At());
}

// --- Contents of the world ---

void ReadShape(DirectiveContext &c) {
    if (auto e = c.NamedEntity("shape", "the shape's name")) c.builder.Shape(std::move(*e));
}
void ReadLightSource(DirectiveContext &c) {
    if (auto e = c.NamedEntity("light", "the light's name")) c.builder.LightSource(std::move(*e));
}
void ReadAreaLightSource(DirectiveContext &c) {
    if (auto e = c.NamedEntity("area light", "the area light's name"))
        c.builder.AreaLightSource(std::move(*e));
}
void ReadMaterial(DirectiveContext &c) {
    if (auto e = c.NamedEntity("material", "the material's name"))
        c.builder.Material(std::move(*e));
}

void ReadMakeNamedMaterial(DirectiveContext &c) {
    const std::optional<std::string> name = c.arguments.Name("the material's name");
    if (!name) return;
    Entity e = c.arguments.EntityOfType("", c.builder.ColorSpace());
    const auto type = std::find_if(e.params.rbegin(), e.params.rend(), [](const auto &p) {
        return p.name == "type" && p.type == "string" && p.strings.size() == 1;
    });
    if (type == e.params.rend()) {
        c.log->Error(c.arguments.At(),
                     fmt::format("material \"{}\" lacks its \"string type\"", *name));
        return c.builder.RefuseNamedMaterial(*name, c.arguments.At());
    }
    e.type = type->strings[0];
    c.NoteIfOld("material", e.type, type->loc);
    std::erase_if(e.params, [](const auto &p) { return p.name == "type" && p.type == "string"; });
    c.builder.MakeNamedMaterial(*name, std::move(e));
}

void ReadNamedMaterial(DirectiveContext &c) {
    if (const auto name = c.arguments.Name("the material's name"))
        c.builder.NamedMaterial(*name, c.arguments.At());
}

void ReadTexture(DirectiveContext &c) {
    constexpr std::array<std::string_view, 2> kKinds{"float", "spectrum"};
    const std::optional<std::string> name = c.arguments.Name("the texture's name");
    const FileLoc loc = c.arguments.Loc();
    const std::optional<std::string> kind =
        name ? c.arguments.Name("\"float\" or \"spectrum\"") : std::nullopt;
    if (!kind) return;
    const bool isFloat = *kind == kKinds[0];
    const OldName *const old = FindOldName("texture type", *kind);
    const bool known = isFloat || *kind == kKinds[1] || old;
    if (!known || (old && c.log->NoteOldName(*old, loc)))
        c.arguments.Error(loc, fmt::format("\"{}\" is not one of {}{}", *kind, QuotedList(kKinds),
                                           old ? fmt::format("; pbrt-v4 calls it \"{}\"", old->is)
                                               : DidYouMean(*kind, kKinds)));
    std::optional<Entity> e = c.NamedEntity("texture class", "the texture's class");
    if (e && known) c.builder.Texture(*name, isFloat, std::move(*e));
}

// --- Media, which this renderer has not ---

void ReadMakeNamedMedium(DirectiveContext &c) {
    const std::optional<std::string> name = c.arguments.Name("the medium's name");
    if (!name) return;
    c.builder.DefineMedium(*name, c.arguments.At());
    const Entity e = c.arguments.EntityOfType(*name, c.builder.ColorSpace());
    std::string_view type;
    for (const ParsedParameter &p : e.params)
        if (p.name == "type" && p.strings.size() == 1) type = p.strings[0];
    const std::string upstream = PbrtHasIt("medium", type);
    c.log->Error(
        c.arguments.At(),
        upstream.empty()
            ? fmt::format("medium \"{}\" is of no type that pbrt-v4 has (\"string type\"), "
                          "and only surfaces are rendered here",
                          *name)
            : fmt::format("medium \"{}\" (\"{}\"): {}", *name, type, upstream));
}

void ReadMediumInterface(DirectiveContext &c) {
    for (int i = 0; i < 2; ++i) {
        if (i == 1 && c.arguments.Peek().kind != TokenKind::String) break;
        const FileLoc loc = c.arguments.Loc();
        const std::optional<std::string> name = c.arguments.Name("the medium's name");
        if (!name) return;
        if (!name->empty()) c.builder.UseMedium(*name, loc);
    }
}

// --- Other files ---

void ReadInclude(DirectiveContext &c) {
    const FileLoc use = c.arguments.Loc();
    if (const auto name = c.arguments.Name("the file's name")) c.readNested(*name, use);
}

void ReadImport(DirectiveContext &c) {
    const FileLoc use = c.arguments.Loc();
    const std::optional<std::string> name = c.arguments.Name("the file's name");
    if (!name) return;
    c.builder.BeginImport();
    c.readNested(*name, use);
    c.builder.EndImport();
}

// --- The list of all ---

using enum Where;

constexpr std::array kDirectives{
    Directive{"Accelerator", BeforeWorld, ReadAccelerator},
    Directive{"ActiveTransform", Anywhere, ReadActiveTransform},
    Directive{"AreaLightSource", InWorld, ReadAreaLightSource},
    Directive{"Attribute", Anywhere, ReadAttribute},
    Directive{"AttributeBegin", InWorld, ReadAttributeBegin},
    Directive{"AttributeEnd", InWorld, ReadAttributeEnd},
    Directive{"Camera", BeforeWorld, ReadCamera},
    Directive{"ColorSpace", Anywhere, ReadColorSpace},
    Directive{"ConcatTransform", Anywhere, ReadConcatTransform},
    Directive{"CoordSysTransform", Anywhere, ReadCoordSysTransform},
    Directive{"CoordinateSystem", Anywhere, ReadCoordinateSystem},
    Directive{"Film", BeforeWorld, ReadFilm},
    Directive{"Identity", Anywhere, ReadIdentity},
    Directive{"Import", InWorld, ReadImport},
    Directive{"Include", Anywhere, ReadInclude},
    Directive{"Integrator", BeforeWorld, ReadIntegrator},
    Directive{"LightSource", InWorld, ReadLightSource},
    Directive{"LookAt", Anywhere, ReadLookAt},
    Directive{"MakeNamedMaterial", InWorld, ReadMakeNamedMaterial},
    Directive{"MakeNamedMedium", Anywhere, ReadMakeNamedMedium},
    Directive{"Material", InWorld, ReadMaterial},
    Directive{"MediumInterface", Anywhere, ReadMediumInterface},
    Directive{"NamedMaterial", InWorld, ReadNamedMaterial},
    Directive{"ObjectBegin", InWorld, ReadObjectBegin},
    Directive{"ObjectEnd", InWorld, ReadObjectEnd},
    Directive{"ObjectInstance", InWorld, ReadObjectInstance},
    Directive{"Option", Anywhere, ReadOption},
    Directive{"PixelFilter", BeforeWorld, ReadPixelFilter},
    Directive{"ReverseOrientation", InWorld, ReadReverseOrientation},
    Directive{"Rotate", Anywhere, ReadRotate},
    Directive{"Sampler", BeforeWorld, ReadSampler},
    Directive{"Scale", Anywhere, ReadScale},
    Directive{"Shape", InWorld, ReadShape},
    Directive{"Texture", InWorld, ReadTexture},
    Directive{"Transform", Anywhere, ReadTransform},
    Directive{"TransformBegin", InWorld, ReadTransformBegin},
    Directive{"TransformEnd", InWorld, ReadTransformEnd},
    Directive{"TransformTimes", BeforeWorld, ReadTransformTimes},
    Directive{"Translate", Anywhere, ReadTranslate},
    Directive{"WorldBegin", Anywhere, ReadWorldBegin},
};

constexpr std::array<std::string_view, kDirectives.size()> kNames = [] {
    std::array<std::string_view, kDirectives.size()> names;
    for (size_t i = 0; i < names.size(); ++i)
        names[i] = kDirectives[i].name;
    return names;
}();

}  // namespace

const Directive *FindDirective(std::string_view name) {
    static const auto byName = [] {
        std::unordered_map<std::string_view, const Directive *> map;
        for (const Directive &d : kDirectives)
            map.emplace(d.name, &d);
        return map;
    }();
    const auto found = byName.find(name);
    return found == byName.end() ? nullptr : found->second;
}

std::span<const std::string_view> DirectiveNames() {
    return kNames;
}

std::string OldDirectiveHint(std::string_view name) {
    if (const OldName *const old = FindOldName("directive", name))
        return old->is.empty() ? "pbrt-v4 scenes end without it"
                               : fmt::format("pbrt-v4 calls it \"{}\"", old->is);
    if (name == "VolumeIntegrator" || name == "Volume" || name == "Renderer")
        return "pbrt-v4 has none";
    return {};
}

}  // namespace pbrt
