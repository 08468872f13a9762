#pragma once

#include <concepts>

#include "pbrt/base/filter.h"
#include "pbrt/filters/filter_table.h"
#include "pbrt/scene/params.h"

namespace pbrt {

namespace detail {
template <typename P>
concept HasProfileSample = requires(const P p, float u) {
    { p.Sample(u) } -> std::same_as<AxisSample>;
};
}  // namespace detail

/// One axis of a filter: an even function of the offset in pixels.
///   kRadius       default of the radius, pixels
///   kClosedForm   has AxisSample Sample(float u) const, u in [0, 1); else it is sampled by a
///                 FilterTable, which takes 4 to 115 KB
///   Shape         what both axes share; Read(params) reads it
///   P(radius, shape), radius    the member is the constructor's argument
///   operator()    its value, 0 beyond the radius
///   Integral()    over the axis, > 0
template <typename P>
concept FilterProfile = PlugInType<P> && requires(const P p, ParamDict &params, float x) {
    { P::kRadius } -> std::convertible_to<float>;
    { P::kClosedForm } -> std::convertible_to<bool>;
    { P::Read(params) } -> std::same_as<typename P::Shape>;
    P(x, P::Read(params));
    { p.radius } -> std::convertible_to<float>;
    { p(x) } -> std::convertible_to<float>;
    { p.Integral() } -> std::same_as<double>;
} &&(P::kClosedForm == detail::HasProfileSample<P>);

/// Product of a profile along x and one along y.
template <FilterProfile Profile>
class SeparableFilter {
  public:
    static constexpr std::string_view kName = Profile::kName;
    static constexpr auto kExamples = Profile::kExamples;
    using Shape = typename Profile::Shape;
    static constexpr FloatParam kXRadius{"xradius", "pixels", Profile::kRadius,
                                         1e-3f,     1e3f,     "half width"};
    static constexpr FloatParam kYRadius{"yradius", "pixels", Profile::kRadius,
                                         1e-3f,     1e3f,     "half height"};

    explicit SeparableFilter(Vector2f radius = {Profile::kRadius, Profile::kRadius},
                             Shape shape = {})
        : x(radius.x, shape), y(radius.y, shape), drawX(Drawing(x)), drawY(Drawing(y)) {}
    static SeparableFilter Create(ParamDict &params) {
        const float rx = params.GetOneFloat(kXRadius), ry = params.GetOneFloat(kYRadius);
        return SeparableFilter({rx, ry}, Profile::Read(params));
    }

    Vector2f Radius() const { return {x.radius, y.radius}; }
    float Evaluate(Point2f p) const { return x(p.x) * y(p.y); }
    /// Over the plane.
    float Integral() const { return float(x.Integral() * y.Integral()); }
    FilterSample Sample(Point2f u) const {
        const AxisSample sx = drawX.Sample(u.x), sy = drawY.Sample(u.y);
        return {{sx.x, sy.x}, sx.weight * sy.weight};
    }

  private:
    /// Profiles that can be sampled in closed form are; the others by table.
    static auto Drawing(const Profile &profile) {
        if constexpr (Profile::kClosedForm)
            return profile;
        else
            return FilterTable(profile, profile.radius);
    }

    Profile x, y;
    decltype(Drawing(std::declval<Profile>())) drawX, drawY;
};

}  // namespace pbrt
