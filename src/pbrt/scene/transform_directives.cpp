// The directives that set the current transformation.

#include <fmt/format.h>

#include "pbrt/scene/parser.h"

namespace pbrt {

void Parser::Concatenate(const std::optional<pbrt::Transform> &t, std::string_view whyNot) {
    if (t)
        builder.Concatenate(*t);
    else
        Error(at, whyNot);
}

void Parser::Identity() {
    builder.Replace({});
}

void Parser::Translate() {
    constexpr std::array<std::string_view, 3> kLabels{"x", "y", "z"};
    if (const auto v = Numbers(kLabels))
        builder.Concatenate(pbrt::Transform::Translate({(*v)[0], (*v)[1], (*v)[2]}));
}

void Parser::Scale() {
    constexpr std::array<std::string_view, 3> kLabels{"x", "y", "z"};
    if (const auto v = Numbers(kLabels))
        Concatenate(pbrt::Transform::Scale({(*v)[0], (*v)[1], (*v)[2]}), "a factor must not be 0");
}

void Parser::Rotate() {
    constexpr std::array<std::string_view, 4> kLabels{"degrees", "axis x", "axis y", "axis z"};
    if (const auto v = Numbers(kLabels))
        Concatenate(pbrt::Transform::Rotate((*v)[0], {(*v)[1], (*v)[2], (*v)[3]}),
                    "the axis must not be 0");
}

void Parser::LookAt() {
    constexpr std::array<std::string_view, 9> kLabels{
        "eye x", "eye y", "eye z", "look x", "look y", "look z", "up x", "up y", "up z"};
    const auto v = Numbers(kLabels);
    if (!v) return;
    const float *n = v->data();
    Concatenate(pbrt::Transform::LookAt({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}),
                "the eye stands on the target, or up is parallel to the view");
}

void Parser::Transform() {
    const std::optional<Matrix4> m = BracketedMatrix();
    if (!m) return;
    if (const auto t = pbrt::Transform::FromMatrix(*m))
        builder.Replace(*t);
    else
        Error(at, "the matrix has no inverse");
}

void Parser::ConcatTransform() {
    if (const std::optional<Matrix4> m = BracketedMatrix())
        Concatenate(pbrt::Transform::FromMatrix(*m), "the matrix has no inverse");
}

void Parser::CoordinateSystem() {
    if (const auto name = Name("the coordinate system's name")) builder.SaveCoordinateSystem(*name);
}

void Parser::CoordSysTransform() {
    const FileLoc loc = lexer->Loc();
    const auto name = Name("the coordinate system's name");
    if (!name || builder.RestoreCoordinateSystem(*name)) return;
    log->Warning(loc, fmt::format("CoordSysTransform: no coordinate system \"{}\"{}; the "
                                  "transformation stays as it was",
                                  *name, DidYouMean(*name, builder.CoordinateSystemNames())));
}

void Parser::ActiveTransform() {
    constexpr std::array<std::string_view, 3> kWhich{"All", "StartTime", "EndTime"};
    const Token &t = lexer->Peek();
    if (t.kind != TokenKind::Word || FindDirective(t.text)) {
        Expected("All, StartTime or EndTime without quotes");
        if (t.kind == TokenKind::String) lexer->Advance();
        return Resynchronise();
    }
    if (t.text == kWhich[0])
        builder.ActivateTransforms(true, true);
    else if (t.text == kWhich[1] || t.text == kWhich[2])
        builder.ActivateTransforms(t.text == kWhich[1], t.text == kWhich[2]);
    else
        Error(lexer->Loc(), fmt::format("{} is not All, StartTime or EndTime{}", Describe(t),
                                        DidYouMean(t.text, kWhich)));
    lexer->Advance();
}

void Parser::TransformTimes() {
    constexpr std::array<std::string_view, 2> kLabels{"start", "end"};
    const auto v = Numbers(kLabels);
    if (!v) return;
    if ((*v)[0] > (*v)[1])
        return Error(at, fmt::format("the start, {}, is later than the end, {}", (*v)[0], (*v)[1]));
    scene->transformStart = (*v)[0];
    scene->transformEnd = (*v)[1];
}

}  // namespace pbrt
