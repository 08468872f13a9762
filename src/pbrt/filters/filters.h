#pragma once

#include <optional>

#include "pbrt/filters/profiles.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// Offset from the pixel's centre and f / pdf, which may be negative.
struct FilterSample {
    Vector2f p;
    float weight;
};

/// Product of a profile along x and one along y.
template <typename Profile>
class SeparableFilter {
  public:
    static constexpr std::string_view kName = Profile::kName;
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
        if constexpr (requires { profile.Sample(0.f); })
            return profile;
        else
            return FilterTable(profile, profile.radius);
    }

    Profile x, y;
    decltype(Drawing(std::declval<Profile>())) drawX, drawY;
};

using BoxFilter = SeparableFilter<BoxProfile>;
using GaussianFilter = SeparableFilter<GaussianProfile>;
using MitchellFilter = SeparableFilter<MitchellProfile>;
using SincFilter = SeparableFilter<SincProfile>;
using TriangleFilter = SeparableFilter<TriangleProfile>;

/// The one list of filters.
using FilterTypes = TypeList<GaussianFilter, BoxFilter, MitchellFilter, SincFilter, TriangleFilter>;
using Filter = FilterTypes::Variant;

/// u in [0, 1)^2.
inline FilterSample Sample(const Filter &filter, Point2f u) {
    return std::visit([u](const auto &f) { return f.Sample(u); }, filter);
}

/// nullopt, with the error reported, where `type` is unknown.
std::optional<Filter> CreateFilter(ParamDict &params, std::string_view type);

}  // namespace pbrt
