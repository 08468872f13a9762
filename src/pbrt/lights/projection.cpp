#include "pbrt/lights/projection.h"

#include "pbrt/textures/image_color_space.h"

namespace pbrt {
namespace {

constexpr StringParam kFileName{"filename", "", "the picture"};
constexpr FloatParam kFov{"fov", "deg",     90,
                          1e-4f, 179.9999f, "angle that the picture's shorter side subtends"};

/// Half the sides of the picture in the plane z = 1.
Point2f HalfSides(Point2i resolution, float fov) {
    const float shorter = std::tan(Radians(fov) / 2);
    const float aspect = float(resolution.x) / float(resolution.y);
    return aspect > 1 ? Point2f{shorter * aspect, shorter} : Point2f{shorter, shorter / aspect};
}

/// The integral of luminance over solid angle, as seen through a transform: texels in the plane
/// z = 1, each at its middle.
float Flux(const Image &image, const RGBColorSpace &space, Point2f half, const Transform &t) {
    const Point2i n = image.Resolution();
    const double volume =
        std::abs(Dot(t.Vector({1, 0, 0}), Cross(t.Vector({0, 1, 0}), t.Vector({0, 0, 1}))));
    double sum = 0;
    for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) {
            const float u = 2 * (float(x) + 0.5f) / float(n.x) - 1;
            const float v = 1 - 2 * (float(y) + 0.5f) / float(n.y);
            const double length = Length(t.Vector({half.x * u, half.y * v, 1}));
            sum += double(Luminance(TexelRGB(image, x, y), space)) / (length * length * length);
        }
    return float(sum * volume * 4 * double(half.x) * double(half.y) / (double(n.x) * double(n.y)));
}

}  // namespace

std::optional<ProjectionLight> ProjectionLight::Create(ParamDict &params,
                                                       const Transform &renderFromLight) {
    const EmissionScale scale = GetScale(params, kLightPower);
    const float fov = params.GetOneFloat(kFov);
    const std::optional<Image> image =
        ReadLightPicture(params, kFileName, {.what = "a projection light"});
    if (!image) return std::nullopt;
    const RGBColorSpace &space = ColorSpaceOf(*image);
    const Point2f half = HalfSides(image->Resolution(), fov);
    const float flux = Flux(*image, space, half, Transform());
    if (scale.target > 0 && !(flux > 0)) {
        params.Error(kLightPower.name, "the picture is black: no scale can give it a power");
        return std::nullopt;
    }
    ProjectionLight light;
    light.projector = std::make_shared<Projector>(
        Projector{LightPicture(*image, space), renderFromLight.Inverse(), half,
                  Flux(*image, space, half, renderFromLight)});
    light.p = renderFromLight.Point({0, 0, 0});
    light.scale = scale.For(flux);
    return light;
}

std::optional<LightBounds> ProjectionLight::Bounds() const {
    // Affine maps keep pyramids, in which a corner lies farthest from the axis.
    const Transform renderFromLight = projector->lightFromRender.Inverse();
    const Point2f half = projector->half;
    const Vector3f axis = Normalize(renderFromLight.Vector({0, 0, 1}));
    float cosTheta = 1;
    for (const float x : {-half.x, half.x})
        for (const float y : {-half.y, half.y})
            cosTheta = std::min(cosTheta, Dot(axis, Normalize(renderFromLight.Vector({x, y, 1}))));
    // The flux of a point light as bright as the picture's mean: that is what a place in the beam
    // receives. A little wider, for directions on the edge.
    const float power = 4 * Pi * scale * projector->picture.MeanLuminance();
    return LightBounds{{p, p}, {axis, std::max(-1.f, cosTheta - 1e-3f)}, 1, power, false};
}

}  // namespace pbrt
