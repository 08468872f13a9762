#include "pbrt/build/instance_range.h"

#include <fmt/format.h>

#include "pbrt/shapes/rounding.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

/// A margin of 8 to where floats have all their digits, of 30 to where they end.
constexpr double kSmallestDeterminant = 1e-37, kLargestDeterminant = 1e37;
/// Least share of the sizes of a determinant's terms that it comes to. Four roundings of 6e-8 of
/// them then make the ray tracer's inverse, and so the instance's size, wrong by 2.4 %.
constexpr double kFlattest = 1e-5;

double Determinant(const Matrix4 &m) {
    const auto row = [&](int i) { return Vector3d{m[i][0], m[i][1], m[i][2]}; };
    return Dot(row(0), Cross(row(1), row(2)));
}
/// Sum of the sizes of the six products that make the determinant.
double TermsOfDeterminant(const Matrix4 &m) {
    const auto size = [&](int row, int column) { return std::abs(double(m[row][column])); };
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += size(0, i) * (size(1, j) * size(2, k) + size(1, k) * size(2, j));
    }
    return sum;
}

std::optional<std::string> WhyNotInverted(const Transform &t) {
    const double volume = std::abs(Determinant(t.Matrix()));
    if (!(volume >= kSmallestDeterminant && volume <= kLargestDeterminant))
        return fmt::format("its transformation scales volumes by {:g}; {:g} to {:g} can be traced",
                           volume, kSmallestDeterminant, kLargestDeterminant);
    if (volume < kFlattest * TermsOfDeterminant(t.Matrix()))
        return "its transformation makes it so flat or skewed that rays cannot be turned into its "
               "space";
    return {};
}

/// Everything that rays start from or end at.
Bounds3f RayEnds(const RenderScene &scene) {
    Bounds3f ends = Origins(scene.camera);
    ends.Grow(scene.accel->WorldBounds());
    for (const Light &light : scene.lights)
        if (const auto place = Bounds(light)) ends.Grow(place->bounds);
    return ends;
}

/// The largest coordinate that a ray has in an instance's space.
float ReachInside(const Transform &renderFromObject, const Bounds3f &ends) {
    const Matrix4 &inverse = renderFromObject.InverseMatrix();
    const float longest = std::max(1.f, Length(ends.Diagonal()));
    return std::max(MaxComponent(AbsPoint(inverse, Max(Abs(ends.min), Abs(ends.max)))),
                    MaxComponent(AbsVector(inverse, {longest, longest, longest})));
}

}  // namespace

std::optional<std::string> WhyNotPlaced(const Instance &instance, const Bounds3f &object) {
    const bool mirrored = instance.Key(0).SwapsHandedness();
    for (size_t i = 0; i < instance.NKeys(); ++i) {
        const Transform key = instance.Key(i);
        if (auto why = WhyNotInverted(key)) return why;
        if (key.SwapsHandedness() != mirrored)
            return "it is mirrored at one end of its motion only, so that it would be flat on the "
                   "way";
        const Bounds3f b = key.Bounds(object);
        if (!IsInRange(b))
            return fmt::format("it reaches to {:g}; only coordinates up to {:g} can be traced",
                               Reach(b), kFarthest);
    }
    return {};
}

void CheckRaysInInstances(const RenderScene &scene, const Places &places, Diagnostics &log) {
    const Bounds3f ends = RayEnds(scene);
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance &instance = scene.instances[i];
        for (size_t k = 0; k < instance.NKeys(); ++k) {
            const float reach = ReachInside(instance.Key(k), ends);
            if (reach <= kMostTraced) continue;
            log.Error(places[i],
                      fmt::format("the instance is scaled down so far that this scene's rays reach "
                                  "to {:g} in its space; only {:g} can be traced",
                                  reach, kMostTraced));
            return;
        }
    }
}

}  // namespace pbrt
