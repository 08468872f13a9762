// What each directive reads (PBRT_FORMAT 1.3).

#include "pbrt/scene/directives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "pbrt/scene/number.h"
#include "pbrt/scene/parser.h"

namespace pbrt {
namespace {

using enum Where;

constexpr std::array kDirectives{
    Directive{"Accelerator", BeforeWorld, &Parser::Accelerator},
    Directive{"ActiveTransform", Anywhere, &Parser::ActiveTransform},
    Directive{"AreaLightSource", InWorld, &Parser::AreaLightSource},
    Directive{"Attribute", Anywhere, &Parser::Attribute},
    Directive{"AttributeBegin", InWorld, &Parser::AttributeBegin},
    Directive{"AttributeEnd", InWorld, &Parser::AttributeEnd},
    Directive{"Camera", BeforeWorld, &Parser::Camera},
    Directive{"ColorSpace", Anywhere, &Parser::ColorSpace},
    Directive{"ConcatTransform", Anywhere, &Parser::ConcatTransform},
    Directive{"CoordSysTransform", Anywhere, &Parser::CoordSysTransform},
    Directive{"CoordinateSystem", Anywhere, &Parser::CoordinateSystem},
    Directive{"Film", BeforeWorld, &Parser::Film},
    Directive{"Identity", Anywhere, &Parser::Identity},
    Directive{"Import", InWorld, &Parser::Import},
    Directive{"Include", Anywhere, &Parser::Include},
    Directive{"Integrator", BeforeWorld, &Parser::Integrator},
    Directive{"LightSource", InWorld, &Parser::LightSource},
    Directive{"LookAt", Anywhere, &Parser::LookAt},
    Directive{"MakeNamedMaterial", InWorld, &Parser::MakeNamedMaterial},
    Directive{"MakeNamedMedium", Anywhere, &Parser::MakeNamedMedium},
    Directive{"Material", InWorld, &Parser::Material},
    Directive{"MediumInterface", Anywhere, &Parser::MediumInterface},
    Directive{"NamedMaterial", InWorld, &Parser::NamedMaterial},
    Directive{"ObjectBegin", InWorld, &Parser::ObjectBegin},
    Directive{"ObjectEnd", InWorld, &Parser::ObjectEnd},
    Directive{"ObjectInstance", InWorld, &Parser::ObjectInstance},
    Directive{"Option", Anywhere, &Parser::Option},
    Directive{"PixelFilter", BeforeWorld, &Parser::PixelFilter},
    Directive{"ReverseOrientation", InWorld, &Parser::ReverseOrientation},
    Directive{"Rotate", Anywhere, &Parser::Rotate},
    Directive{"Sampler", BeforeWorld, &Parser::Sampler},
    Directive{"Scale", Anywhere, &Parser::Scale},
    Directive{"Shape", InWorld, &Parser::Shape},
    Directive{"Texture", InWorld, &Parser::Texture},
    Directive{"Transform", Anywhere, &Parser::Transform},
    Directive{"TransformBegin", InWorld, &Parser::TransformBegin},
    Directive{"TransformEnd", InWorld, &Parser::TransformEnd},
    Directive{"TransformTimes", BeforeWorld, &Parser::TransformTimes},
    Directive{"Translate", Anywhere, &Parser::Translate},
    Directive{"WorldBegin", Anywhere, &Parser::WorldBegin},
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

std::string_view OldDirectiveHint(std::string_view name) {
    if (name == "WorldEnd") return "pbrt-v4 scenes end without it";
    if (name == "SurfaceIntegrator") return "pbrt-v4 calls it \"Integrator\"";
    if (name == "VolumeIntegrator" || name == "Volume" || name == "Renderer")
        return "pbrt-v4 has none";
    return {};
}

// --- Settings of the whole picture ---

void Parser::Accelerator() {
    if (auto e = NamedEntity("the accelerator's name")) scene->accelerator = std::move(*e);
}
void Parser::Camera() {
    if (auto e = NamedEntity("the camera's name")) builder.Camera(std::move(*e));
}
void Parser::Film() {
    if (auto e = NamedEntity("the film's name")) scene->film = std::move(*e);
}
void Parser::Integrator() {
    if (auto e = NamedEntity("the integrator's name")) scene->integrator = std::move(*e);
}
void Parser::PixelFilter() {
    if (auto e = NamedEntity("the filter's name")) scene->filter = std::move(*e);
}
void Parser::Sampler() {
    if (auto e = NamedEntity("the sampler's name")) scene->sampler = std::move(*e);
}

void Parser::ColorSpace() {
    const FileLoc loc = lexer->Loc();
    const std::optional<std::string> name = Name("the colour space's name");
    if (!name) return;
    if (const RGBColorSpace *space = RGBColorSpace::Named(*name))
        return builder.SetColorSpace(space);
    Error(loc, fmt::format("\"{}\" is not one of {}{}", *name, QuotedList(RGBColorSpace::Names()),
                           DidYouMean(*name, RGBColorSpace::Names())));
}

void Parser::Attribute() {
    const FileLoc loc = lexer->Loc();
    const std::optional<std::string> name = Name("the target's name");
    if (!name) return;
    const auto target = std::find(kAttributeTargets.begin(), kAttributeTargets.end(), *name);
    const bool known = target != kAttributeTargets.end();
    if (!known)
        Error(loc, fmt::format("\"{}\" is not one of {}{}", *name, QuotedList(kAttributeTargets),
                               DidYouMean(*name, kAttributeTargets)));
    ParsedParameters list = parameters.Read(*lexer, builder.ColorSpace());
    if (known)
        builder.AddAttribute(AttributeTarget(target - kAttributeTargets.begin()), std::move(list));
}

void Parser::ReverseOrientation() {
    builder.ReverseOrientation();
}
void Parser::WorldBegin() {
    if (builder.InWorld())
        return log->Error(at, fmt::format("a second WorldBegin; the first is at {}:{}:{}",
                                          worldBegin.file, worldBegin.line, worldBegin.column));
    worldBegin = at;
    builder.WorldBegin();
}

// --- Scopes ---

void Parser::AttributeBegin() {
    builder.AttributeBegin(at);
}
void Parser::AttributeEnd() {
    builder.AttributeEnd(at);
}
void Parser::TransformBegin() {
    if (!saidTransformBegin)
        log->Warning(at,
                     "TransformBegin and TransformEnd are read as AttributeBegin and "
                     "AttributeEnd: pbrt-v4 has only these");
    saidTransformBegin = true;
    AttributeBegin();
}
void Parser::TransformEnd() {
    AttributeEnd();
}

void Parser::ObjectBegin() {
    const std::optional<std::string> name = Name("the object's name");
    builder.ObjectBegin(name.value_or(""), at);
}
void Parser::ObjectEnd() {
    builder.ObjectEnd(at);
}
void Parser::ObjectInstance() {
    if (const auto name = Name("the object's name")) builder.ObjectInstance(*name, at);
}

// --- Contents of the world ---

void Parser::Shape() {
    if (auto e = NamedEntity("the shape's name")) builder.Shape(std::move(*e));
}
void Parser::LightSource() {
    if (auto e = NamedEntity("the light's name")) builder.LightSource(std::move(*e));
}
void Parser::AreaLightSource() {
    if (auto e = NamedEntity("the area light's name")) builder.AreaLightSource(std::move(*e));
}
void Parser::Material() {
    if (auto e = NamedEntity("the material's name")) builder.Material(std::move(*e));
}

void Parser::MakeNamedMaterial() {
    const std::optional<std::string> name = Name("the material's name");
    if (!name) return;
    Entity e = EntityOfType("");
    const auto type = std::find_if(e.params.rbegin(), e.params.rend(), [](const auto &p) {
        return p.name == "type" && p.type == "string" && p.strings.size() == 1;
    });
    if (type == e.params.rend()) {
        log->Error(at, fmt::format("material \"{}\" lacks its \"string type\"", *name));
        return builder.RefuseNamedMaterial(*name, at);
    }
    e.type = type->strings[0];
    std::erase_if(e.params, [](const auto &p) { return p.name == "type" && p.type == "string"; });
    builder.MakeNamedMaterial(*name, std::move(e));
}

void Parser::NamedMaterial() {
    if (const auto name = Name("the material's name")) builder.NamedMaterial(*name, at);
}

void Parser::Texture() {
    constexpr std::array<std::string_view, 2> kKinds{"float", "spectrum"};
    const std::optional<std::string> name = Name("the texture's name");
    const FileLoc loc = lexer->Loc();
    const std::optional<std::string> kind = name ? Name("\"float\" or \"spectrum\"") : std::nullopt;
    if (!kind) return;
    const bool known = *kind == kKinds[0] || *kind == kKinds[1];
    if (!known)
        Error(loc, fmt::format("\"{}\" is not one of {}{}", *kind, QuotedList(kKinds),
                               *kind == "color" ? "; pbrt-v4 calls it \"spectrum\""
                                                : DidYouMean(*kind, kKinds)));
    std::optional<Entity> e = NamedEntity("the texture's class");
    if (e && known) builder.Texture(*name, *kind == kKinds[0], std::move(*e));
}

// --- Media, which this renderer has not ---

void Parser::MakeNamedMedium() {
    if (const auto name = Name("the medium's name")) EntityOfType(*name);
    log->Error(at, "participating media are not supported");
}

void Parser::MediumInterface() {
    bool vacuum = true;
    for (int i = 0; i < 2; ++i) {
        if (i == 1 && lexer->Peek().kind != TokenKind::String) break;
        const std::optional<std::string> name = Name("the medium's name");
        if (!name) return;
        vacuum = vacuum && name->empty();
    }
    if (!vacuum) log->Error(at, "participating media are not supported");
}

// --- Other files ---

void Parser::Include() {
    const FileLoc use = lexer->Loc();
    if (const auto name = Name("the file's name")) ReadNested(*name, use);
}

void Parser::Import() {
    const FileLoc use = lexer->Loc();
    const std::optional<std::string> name = Name("the file's name");
    if (!name) return;
    builder.BeginImport();
    ReadNested(*name, use);
    builder.EndImport();
}

}  // namespace pbrt
