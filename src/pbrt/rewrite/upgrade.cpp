#include "pbrt/rewrite/upgrade.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pbrt/rewrite/upgrade_plug_ins.h"
#include "pbrt/util/upstream.h"

namespace pbrt::rewrite {
namespace {

struct Upgrader {
    std::string_view directive;
    std::string_view kind;  ///< of its plug-ins, as OldName has it
    void (*upgrade)(std::string *type, Statement *s, Diagnostics *log);
};
constexpr std::array kUpgraders{
    Upgrader{"AreaLightSource", "area light", UpgradeAreaLight},
    Upgrader{"Camera", "camera", UpgradeCamera},
    Upgrader{"Film", "film", UpgradeFilm},
    Upgrader{"Integrator", "integrator", UpgradeIntegrator},
    Upgrader{"LightSource", "light", UpgradeLight},
    Upgrader{"Material", "material", UpgradeMaterial},
    Upgrader{"PixelFilter", "filter", UpgradeFilter},
    Upgrader{"Sampler", "sampler", UpgradeSampler},
    Upgrader{"Shape", "shape", UpgradeShape},
    Upgrader{"Texture", "texture class", UpgradeTexture},
};

/// Directives of pbrt-v3 that set what holds until the end of its AttributeBegin.
constexpr std::array<std::string_view, 5> kSetState{
    "AreaLightSource", "Material", "MediumInterface", "NamedMaterial", "ReverseOrientation"};

/// Nothing but the comments stays.
void LeaveOut(Statement *s) {
    s->directive.clear();
    if (!s->remark.empty()) s->comments.push_back(s->remark);
    for (const Parameter &p : s->parameters) {
        s->comments.insert(s->comments.end(), p.comments.begin(), p.comments.end());
        if (!p.remark.empty()) s->comments.push_back(p.remark);
    }
}

}  // namespace

void Upgrade::Apply(Statement *s) {
    if (const OldName *const old = FindOldName("directive", s->directive)) s->directive = old->is;
    for (const std::string_view gone : {"Renderer", "Volume", "VolumeIntegrator"})
        if (s->directive == gone) {
            log->Warning(s->loc, fmt::format("{} is left out: pbrt-v4 has none", gone));
            return LeaveOut(s);
        }
    if (s->directive == "Include" || s->directive == "Import")
        log->WarningOnce(s->loc,
                         "files of Include and Import stay as they are; where they are of "
                         "pbrt-v3, upgrade each by itself");
    OpenOrClose(s);
    RenameUsed(s);
    RenamePlugIn(s);
    if (s->directive == "MakeNamedMaterial") Define("material", s);
    if (s->directive == "ObjectBegin" && !s->arguments.empty()) Define("object", s);
    if (s->directive == "Texture") Define(Unquoted(s->arguments[1]) + " texture", s);
}

void Upgrade::OpenOrClose(Statement *s) {
    const std::string name = s->directive;
    const bool isTransform = name == "TransformBegin" || name == "TransformEnd";
    if (isTransform) s->directive = "Attribute" + name.substr(std::string("Transform").size());
    if (name == "AttributeBegin" || name == "TransformBegin" || name == "ObjectBegin")
        scopes.push_back({scopes.back().names, isTransform});
    if ((name == "AttributeEnd" || name == "TransformEnd" || name == "ObjectEnd") &&
        scopes.size() > 1) {
        const Scope ended = std::move(scopes.back());
        scopes.pop_back();
        if (ended.isTransform) scopes.back().names = ended.names;
    }
    if (scopes.back().isTransform) WarnOfLeak(*s);
}

void Upgrade::WarnOfLeak(const Statement &s) {
    if (std::find(kSetState.begin(), kSetState.end(), s.directive) != kSetState.end())
        log->Warning(s.loc, fmt::format("{} inside of TransformBegin: in pbrt-v3 it holds beyond "
                                        "TransformEnd, in pbrt-v4 not; repeat it there",
                                        s.directive));
}

void Upgrade::RenamePlugIn(Statement *s) {
    const bool isNamed = s->directive == "MakeNamedMaterial";
    Parameter *const typeParameter = isNamed ? s->Find("type") : nullptr;
    if (isNamed && (!typeParameter || typeParameter->values.size() != 1)) return;
    const std::string_view directive = isNamed ? "Material" : std::string_view(s->directive);
    const auto *const row =
        std::find_if(kUpgraders.begin(), kUpgraders.end(),
                     [&](const Upgrader &u) { return u.directive == directive; });
    if (row == kUpgraders.end()) return;
    std::string type = Unquoted(isNamed ? typeParameter->values[0] : s->arguments.back());
    const std::string was = type;
    if (const OldName *const old = FindOldName(row->kind, type)) type = old->is;
    row->upgrade(&type, s, log);
    RenameParameters(s);
    if (type == was) return;
    if (isNamed)
        s->Find("type")->values[0] = Quoted(type);
    else
        s->arguments.back() = Quoted(type);
}

void Upgrade::RenameParameters(Statement *s) {
    for (Parameter &p : s->parameters)
        if (const OldName *const old = FindOldName("parameter", p.name)) p.name = old->is;
}

// --- Names that are defined twice ---

void Upgrade::Define(std::string_view kind, Statement *s) {
    const std::string name = Unquoted(s->arguments[0]), key = fmt::format("{} {}", kind, name);
    std::string now = name;
    for (int i = 2; !defined.insert(fmt::format("{} {}", kind, now)).second; ++i)
        now = fmt::format("{}-{}", name, i);
    for (Scope &scope : scopes)
        if (&scope == &scopes.back() || kind == "object") scope.names[key] = now;
    if (now == name) return;
    log->Warning(s->loc, fmt::format("{} \"{}\" is defined before; here it becomes \"{}\"", kind,
                                     name, now));
    s->arguments[0] = Quoted(now);
}

std::string Upgrade::Current(std::string_view kind, const std::string &quoted) const {
    const auto found = scopes.back().names.find(fmt::format("{} {}", kind, Unquoted(quoted)));
    return found == scopes.back().names.end() ? quoted : Quoted(found->second);
}

void Upgrade::RenameUsed(Statement *s) {
    if (s->arguments.empty()) return;
    if (s->directive == "NamedMaterial") s->arguments[0] = Current("material", s->arguments[0]);
    if (s->directive == "ObjectInstance") s->arguments[0] = Current("object", s->arguments[0]);
    for (Parameter &p : s->parameters) {
        if (p.name == "namedmaterial1" || p.name == "namedmaterial2" || p.name == "materials")
            for (std::string &value : p.values)
                value = Current("material", value);
        if (p.type != "texture" || p.values.size() != 1) continue;
        const std::string color = Current("spectrum texture", p.values[0]);
        const std::string number = Current("float texture", p.values[0]);
        if (color != p.values[0] && number != p.values[0] && color != number)
            log->Error(p.loc, fmt::format("there are several textures {}, of colors and of "
                                          "numbers: give them names of their own first",
                                          p.values[0]));
        p.values[0] = color != p.values[0] ? color : number;
    }
}

}  // namespace pbrt::rewrite
