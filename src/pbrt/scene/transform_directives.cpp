#include "pbrt/scene/transform_directives.h"

#include <fmt/format.h>

#include <array>

namespace pbrt {
namespace {

/// A matrix without inverse is no mistake: animations write them for what they hide.
void Flatten(DirectiveContext &c) {
    c.builder.Flatten();
    c.log->WarningOnce(c.arguments.At(),
                       "this transformation has no inverse: shapes, objects and lights that it "
                       "places are left out");
}

/// Multiplies the current transformation by `t`; `whyNot` is the error where there is none.
void Concatenate(DirectiveContext &c, const std::optional<Transform> &t, std::string_view whyNot) {
    if (t)
        c.builder.Concatenate(*t);
    else
        c.arguments.Error(c.arguments.At(), whyNot);
}

void ConcatenateOrFlatten(DirectiveContext &c, const std::optional<Transform> &t) {
    if (t)
        c.builder.Concatenate(*t);
    else
        Flatten(c);
}

}  // namespace

void ReadIdentity(DirectiveContext &c) {
    c.builder.Replace({});
}

void ReadTranslate(DirectiveContext &c) {
    constexpr std::array<std::string_view, 3> kLabels{"x", "y", "z"};
    if (const auto v = c.arguments.Numbers(kLabels))
        c.builder.Concatenate(Transform::Translate({(*v)[0], (*v)[1], (*v)[2]}));
}

void ReadScale(DirectiveContext &c) {
    constexpr std::array<std::string_view, 3> kLabels{"x", "y", "z"};
    if (const auto v = c.arguments.Numbers(kLabels))
        ConcatenateOrFlatten(c, Transform::Scale({(*v)[0], (*v)[1], (*v)[2]}));
}

void ReadRotate(DirectiveContext &c) {
    constexpr std::array<std::string_view, 4> kLabels{"degrees", "axis x", "axis y", "axis z"};
    if (const auto v = c.arguments.Numbers(kLabels))
        Concatenate(c, Transform::Rotate((*v)[0], {(*v)[1], (*v)[2], (*v)[3]}),
                    "the axis must not be 0");
}

void ReadLookAt(DirectiveContext &c) {
    constexpr std::array<std::string_view, 9> kLabels{
        "eye x", "eye y", "eye z", "look x", "look y", "look z", "up x", "up y", "up z"};
    const auto v = c.arguments.Numbers(kLabels);
    if (!v) return;
    const float *n = v->data();
    Concatenate(c, Transform::LookAt({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}),
                "the eye stands on the target, or up is parallel to the view");
}

void ReadTransform(DirectiveContext &c) {
    const std::optional<Matrix4> m = c.arguments.BracketedMatrix();
    if (!m) return;
    const std::optional<Transform> t = Transform::FromMatrix(*m);
    c.builder.Replace(t.value_or(Transform()));
    if (!t) Flatten(c);
}

void ReadConcatTransform(DirectiveContext &c) {
    if (const std::optional<Matrix4> m = c.arguments.BracketedMatrix())
        ConcatenateOrFlatten(c, Transform::FromMatrix(*m));
}

void ReadCoordinateSystem(DirectiveContext &c) {
    if (const auto name = c.arguments.Name("the coordinate system's name"))
        c.builder.SaveCoordinateSystem(*name);
}

void ReadCoordSysTransform(DirectiveContext &c) {
    const FileLoc loc = c.arguments.Loc();
    const auto name = c.arguments.Name("the coordinate system's name");
    if (!name || c.builder.RestoreCoordinateSystem(*name)) return;
    c.log->Warning(loc, fmt::format("CoordSysTransform: no coordinate system \"{}\"{}; the "
                                    "transformation stays as it was",
                                    *name, DidYouMean(*name, c.builder.CoordinateSystemNames())));
}

void ReadActiveTransform(DirectiveContext &c) {
    constexpr std::array<std::string_view, 3> kWhich{"All", "StartTime", "EndTime"};
    const Token &t = c.arguments.Peek();
    if (t.kind != TokenKind::Word || c.arguments.IsDirective(t)) {
        c.arguments.Expected("All, StartTime or EndTime without quotes");
        if (t.kind == TokenKind::String) c.arguments.Advance();
        return c.arguments.Resynchronise();
    }
    if (t.text == kWhich[0])
        c.builder.ActivateTransforms(true, true);
    else if (t.text == kWhich[1] || t.text == kWhich[2])
        c.builder.ActivateTransforms(t.text == kWhich[1], t.text == kWhich[2]);
    else
        c.arguments.Error(c.arguments.Loc(), fmt::format("{} is not All, StartTime or EndTime{}",
                                                         Describe(t), DidYouMean(t.text, kWhich)));
    c.arguments.Advance();
}

void ReadTransformTimes(DirectiveContext &c) {
    constexpr std::array<std::string_view, 2> kLabels{"start", "end"};
    const auto v = c.arguments.Numbers(kLabels);
    if (!v) return;
    if ((*v)[0] > (*v)[1])
        return c.arguments.Error(
            c.arguments.At(),
            fmt::format("the start, {}, is later than the end, {}", (*v)[0], (*v)[1]));
    c.scene->transformStart = (*v)[0];
    c.scene->transformEnd = (*v)[1];
}

}  // namespace pbrt
