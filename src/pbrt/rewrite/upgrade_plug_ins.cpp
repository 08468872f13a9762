#include "pbrt/rewrite/upgrade_plug_ins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pbrt/util/upstream.h"

namespace pbrt::rewrite {

std::optional<float> GrayOf(const Parameter &p) {
    const std::optional<std::vector<float>> numbers = Numbers(p);
    if (!numbers || numbers->size() != (p.type == "rgb" ? 3 : 1)) return {};
    if (p.type != "rgb" && p.type != "float") return {};
    const bool same = std::all_of(numbers->begin(), numbers->end(),
                                  [&](float number) { return number == numbers->front(); });
    return same ? std::optional(numbers->front()) : std::nullopt;
}

void Drop(std::string_view name, std::optional<float> silent, Statement *s, Diagnostics *log) {
    const Parameter *const p = s->Find(name);
    if (!p) return;
    if (!silent || GrayOf(*p) != silent)
        log->Warning(p->loc, fmt::format("\"{} {}\" is left out: pbrt-v4 has no such parameter",
                                         p->type, p->name));
    s->Remove(name);
}

std::string Written(float number) {
    return fmt::format("{}", number);
}

namespace {

/// Takes out parameters that pbrt-v4 does without and no picture depends on.
void DropSilently(std::initializer_list<std::string_view> names, Statement *s) {
    for (const std::string_view name : names)
        s->Remove(name);
}

/// The number of a parameter "float name", which is removed.
std::optional<float> TakeFloat(std::string_view name, Statement *s) {
    const Parameter *const p = s->Find(name);
    const std::optional<float> number = p && p->type == "float" ? GrayOf(*p) : std::nullopt;
    if (number) s->Remove(name);
    return number;
}

/// Takes a gray parameter out and multiplies `scale` by it; false where it is not gray.
bool TakeFactor(std::string_view name, float *scale, Statement *s) {
    const Parameter *const p = s->Find(name);
    if (!p) return true;
    const std::optional<float> gray = GrayOf(*p);
    if (!gray) return false;
    *scale *= *gray;
    s->Remove(name);
    return true;
}

/// `"blackbody L" [ kelvin scale ]` of pbrt-v3 loses its scale.
void TakeBlackbodyScale(std::string_view name, float *scale, Statement *s) {
    Parameter *const p = s->Find(name);
    if (!p || p->type != "blackbody" || p->values.size() != 2) return;
    const std::optional<std::vector<float>> numbers = Numbers(*p);
    if (!numbers) return;
    *scale *= (*numbers)[1];
    p->values.pop_back();
}

/// "scale", which was a color, times `factor` and the scales of black bodies.
void UpgradeScale(float factor, Statement *s, Diagnostics *log) {
    TakeBlackbodyScale("L", &factor, s);
    TakeBlackbodyScale("I", &factor, s);
    const Parameter *const given = s->Find("scale");
    if (given && given->type == "float" && factor == 1) return;
    if (!TakeFactor("scale", &factor, s))
        return log->Error(given->loc,
                          "the \"scale\" of lights is a number in pbrt-v4: multiply \"L\" or \"I\" "
                          "by this color");
    if (factor != 1) s->Add("float", "scale", {Written(factor)});
}

}  // namespace

void UpgradeAreaLight(std::string *, Statement *s, Diagnostics *log) {
    DropSilently({"nsamples", "samples"}, s);
    UpgradeScale(1, s, log);
}

void UpgradeLight(std::string *type, Statement *s, Diagnostics *log) {
    DropSilently({"nsamples", "samples"}, s);
    float scale = 1;
    if (const Parameter *const picture = s->Find("mapname")) {
        const std::string_view color = *type == "projection" ? "I" : "L";
        const bool hasColor = *type == "projection" || *type == "infinite";
        if (hasColor && !TakeFactor(color, &scale, s))
            log->Error(s->Find(color)->loc,
                       fmt::format("\"{}\" beside a picture is no color in pbrt-v4: color the "
                                   "picture",
                                   color));
        if (*type == "infinite" || *type == "goniometric")
            log->Warning(picture->loc,
                         "pbrt-v4 takes square pictures in the equal-area layout: "
                         "\"imgtool makeequiarea\" makes them of pbrt-v3's");
    }
    UpgradeScale(scale, s, log);
}

void UpgradeCamera(std::string *, Statement *s, Diagnostics *) {
    if (Unquoted(s->arguments[0]) == "environment")
        s->Add("string", "mapping", {Quoted("equirectangular")});
    DropSilently({"simpleweighting"}, s);
}

void UpgradeFilm(std::string *, Statement *s, Diagnostics *) {
    constexpr float kIsoOfScaleOne = 100;
    if (const auto scale = TakeFloat("scale", s))
        s->Add("float", "iso", {Written(kIsoOfScaleOne * *scale)});
}

void UpgradeFilter(std::string *type, Statement *s, Diagnostics *) {
    if (*type != "gaussian") return;
    // exp(-alpha x^2) = exp(-x^2 / (2 sigma^2)).
    if (const auto alpha = TakeFloat("alpha", s))
        s->Add("float", "sigma", {Written(1 / std::sqrt(2 * *alpha))});
}

void UpgradeIntegrator(std::string *, Statement *s, Diagnostics *log) {
    const std::string was = Unquoted(s->arguments[0]);
    DropSilently({"rrthreshold", "imagewritefrequency", "imagewritefreq"}, s);
    if (was == "directlighting") {
        DropSilently({"strategy"}, s);
        if (!s->Find("maxdepth")) s->Add("integer", "maxdepth", {"1"});
    }
    if (const Parameter *const iterations = s->Find("numiterations")) {
        log->Warning(iterations->loc,
                     "\"numiterations\" is left out: pbrt-v4 takes the sampler's pixelsamples");
        s->Remove("numiterations");
    }
    Parameter *const lights = s->Find("lightsamplestrategy");
    if (!lights || lights->values.size() != 1) return;
    lights->name = "lightsampler";
    if (lights->values[0] == Quoted("spatial")) lights->values[0] = Quoted("bvh");
}

void UpgradeSampler(std::string *, Statement *s, Diagnostics *) {
    DropSilently({"dimensions", "samplepixelcenter"}, s);
}

void UpgradeShape(std::string *type, Statement *s, Diagnostics *log) {
    if (Parameter *const levels = s->Find("nlevels"); levels && *type == "loopsubdiv")
        levels->name = "levels";
    DropSilently({"discarddegenerateUVs", "shadowalpha"}, s);
    if (*type != "trianglemesh") return;
    // "st" counts before "uv", as does points before plain numbers.
    for (const char *const name : {"uv", "st"}) {
        Parameter *const uv = s->Find(name);
        if (!uv || (uv->type != "float" && uv->type != "point2")) continue;
        if (uv->values.size() % 2 != 0)
            return log->Error(uv->loc, fmt::format("\"{}\" has an odd number of values", name));
        uv->type = "point2";
        if (uv->name == "uv") continue;
        s->Remove("uv");
        s->Find("st")->name = "uv";
    }
}

// --- Textures ---

namespace {

/// In pbrt-v4 a texture is times a number: of two colors one must be gray.
void UpgradeColorScale(Statement *s, Diagnostics *log) {
    Parameter *factor = nullptr;
    for (const char *const name : {"tex2", "tex1"})
        if (Parameter *const p = s->Find(name); p && !factor && GrayOf(*p)) factor = p;
    Parameter *const first = s->Find("tex1"), *const second = s->Find("tex2");
    Parameter *const texture = factor == second ? first : second;
    if (first && second && !factor)
        return log->Error(s->loc,
                          "pbrt-v4 multiplies a texture of colors by a number only, and neither "
                          "\"tex1\" nor \"tex2\" is gray");
    if (!first || !second) factor = nullptr;  // the other is 1
    if (factor) {
        factor->values.resize(1);
        factor->type = "float";
        factor->name = "scale";
    }
    if (Parameter *const only = texture ? texture : first; only && only != factor)
        only->name = "tex";
}

void UpgradeImage(Statement *s) {
    if (Parameter *const trilinear = s->Find("trilinear"); trilinear && trilinear->type == "bool") {
        const bool on = trilinear->values[0] == "true";
        trilinear->type = "string", trilinear->name = "filter";
        trilinear->values = {Quoted(on ? "trilinear" : "bilinear")};
    }
    Parameter *const gamma = s->Find("gamma");
    if (!gamma || gamma->values.size() != 1) return;
    const std::string value = gamma->values[0];
    const bool isBool = gamma->type == "bool";
    gamma->type = "string", gamma->name = "encoding";
    gamma->values = {Quoted(!isBool ? "gamma " + value : value == "true" ? "sRGB" : "linear")};
}

}  // namespace

void UpgradeTexture(std::string *type, Statement *s, Diagnostics *log) {
    const bool isFloat = Unquoted(s->arguments[1]) == "float";
    if (const OldName *const old = FindOldName("texture type", Unquoted(s->arguments[1])))
        s->arguments[1] = Quoted(old->is);
    if (*type == "checkerboard") DropSilently({"aamode"}, s);
    if (*type == "imagemap" || *type == "ptex") UpgradeImage(s);
    if (*type != "scale") return;
    if (!isFloat) return UpgradeColorScale(s, log);
    if (Parameter *const p = s->Find("tex1")) p->name = "tex";
    if (Parameter *const p = s->Find("tex2")) p->name = "scale";
}

}  // namespace pbrt::rewrite
