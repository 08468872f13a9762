#include <fmt/format.h>

#include <array>

#include "pbrt/rewrite/upgrade_plug_ins.h"

namespace pbrt::rewrite {
namespace {

/// A parameter that pbrt-v4's material does without.
struct Dropped {
    std::string_view material, name;
    std::optional<float> silent = std::nullopt;  ///< the value that changes nothing
};
constexpr std::array kDropped{
    Dropped{"disney", "anisotropic", 0.f},
    Dropped{"disney", "clearcoat", 0.f},
    Dropped{"disney", "clearcoatgloss"},
    Dropped{"disney", "difftrans"},
    Dropped{"disney", "eta"},
    Dropped{"disney", "flatness", 0.f},
    Dropped{"disney", "metallic", 0.f},
    Dropped{"disney", "roughness"},
    Dropped{"disney", "scatterdistance", 0.f},
    Dropped{"disney", "sheen", 0.f},
    Dropped{"disney", "sheentint"},
    Dropped{"disney", "spectrans", 0.f},
    Dropped{"disney", "speculartint", 0.f},
    Dropped{"disney", "thin"},
    Dropped{"glass", "Kr", 1.f},
    Dropped{"glass", "Kt", 1.f},
    Dropped{"matte", "sigma", 0.f},
    Dropped{"metal", "Kr", 1.f},
    Dropped{"mirror", "Kr"},
    Dropped{"plastic", "Ks"},
    Dropped{"substrate", "Ks"},
    Dropped{"translucent", "Ks", 0.f},
    Dropped{"translucent", "remaproughness"},
    Dropped{"translucent", "roughness"},
    Dropped{"uber", "Kr", 0.f},
    Dropped{"uber", "Ks"},
    Dropped{"uber", "Kt", 0.f},
    Dropped{"uber", "opacity", 1.f},
};

void Rename(std::string_view was, std::string_view is, Statement *s) {
    if (Parameter *const p = s->Find(was)) p->name = is;
}

/// Gray of the parameter, or its default in pbrt-v3; nullopt where it is a color or a texture.
std::optional<float> GrayOr(float byDefault, std::string_view name, Statement *s) {
    const Parameter *const p = s->Find(name);
    return p ? GrayOf(*p) : std::optional(byDefault);
}

/// A coat that reflects nothing is none.
void UpgradeGloss(std::string *type, Statement *s) {
    if (GrayOr(1, "Ks", s) != 0) return;
    *type = "diffuse";
    for (const char *const name :
         {"Ks", "roughness", "uroughness", "vroughness", "remaproughness", "eta", "index"})
        s->Remove(name);
}

/// pbrt-v4's mix has its materials the other way round: amount 1 takes the second.
void UpgradeMix(Statement *s, Diagnostics *log) {
    const Parameter *const first = s->Find("namedmaterial1"), *const second =
                                                                  s->Find("namedmaterial2");
    if (!first && !second) return;  // of pbrt-v4
    if (!first || !second)
        return log->Error(s->loc, "mix needs both \"namedmaterial1\" and \"namedmaterial2\"");
    std::vector<std::string> names = second->values;
    names.insert(names.end(), first->values.begin(), first->values.end());
    s->Remove("namedmaterial1");
    s->Remove("namedmaterial2");
    s->Add("string", "materials", names);
    Parameter *const amount = s->Find("amount");
    if (!amount || amount->type == "texture" || amount->type == "float") return;
    const std::optional<float> gray = GrayOf(*amount);
    if (!gray)
        return log->Error(amount->loc, "the \"amount\" of mix is a number in pbrt-v4, no color");
    amount->type = "float";
    amount->values = {Written(*gray)};
}

/// pbrt-v3 reflects and transmits Kd times "reflect" and "transmit".
void UpgradeTranslucent(Statement *s, Diagnostics *log) {
    constexpr float kHalf = 0.5f, kKd = 0.25f;
    const std::optional<float> reflect = GrayOr(kHalf, "reflect", s),
                               transmit = GrayOr(kHalf, "transmit", s);
    if (!reflect || !transmit || (*reflect != *transmit && *reflect != 0 && *transmit != 0))
        return log->Error(s->loc,
                          "\"reflect\" and \"transmit\" of translucent: pbrt-v4 takes the colors "
                          "\"reflectance\" and \"transmittance\" instead; write these");
    s->Remove("reflect");
    s->Remove("transmit");
    if (!s->Find("Kd")) s->Add("rgb", "Kd", std::vector<std::string>(3, Written(kKd)));
    const Parameter color = *s->Find("Kd");
    s->Remove("Kd");
    const std::vector<std::string> black(3, "0");
    const float scale = *reflect != 0 ? *reflect : *transmit;
    if (scale != 1) s->Add("float", "scale", {Written(scale)});
    for (const auto &[name, factor] :
         {std::pair("transmittance", *transmit), std::pair("reflectance", *reflect)})
        s->Add(factor != 0 ? color.type : "rgb", name, factor != 0 ? color.values : black);
}

}  // namespace

void UpgradeMaterial(std::string *type, Statement *s, Diagnostics *log) {
    const Parameter *const named = s->directive == "MakeNamedMaterial" ? s->Find("type") : nullptr;
    const std::string was = Unquoted(named ? named->values[0] : s->arguments[0]);
    if (was == "fourier")
        return log->Error(s->loc, "material \"fourier\" has no like in pbrt-v4; write another");
    if (was.empty() || was == "none") *type = "interface";
    if (was == "plastic" || was == "uber") UpgradeGloss(type, s);
    if (was == "mix") UpgradeMix(s, log);
    if (was == "translucent") UpgradeTranslucent(s, log);
    if (was == "disney") Rename("color", "reflectance", s);
    if (was == "hair") Rename("color", "reflectance", s);
    if ((was == "glass" || was == "uber") && s->Find("index")) {
        if (s->Find("eta"))
            return log->Error(s->Find("index")->loc, "both \"index\" and \"eta\": leave one out");
        Rename("index", "eta", s);
    }
    const Parameter *const opacity = s->Find("opacity");
    if (was == "uber" && opacity && GrayOf(*opacity) != 1.f)
        return log->Error(opacity->loc,
                          "pbrt-v4 has no \"opacity\" of materials: give the shapes "
                          "an \"alpha\", and leave it out here");
    for (const Dropped &d : kDropped)
        if (d.material == was) Drop(d.name, d.silent, s, log);
    if (was != "mirror") return;
    // pbrt-v4's --upgrade takes silver, too.
    s->Add("spectrum", "k", {Quoted("metal-Ag-k")});
    s->Add("spectrum", "eta", {Quoted("metal-Ag-eta")});
    s->Add("float", "roughness", {"0"});
}

}  // namespace pbrt::rewrite
