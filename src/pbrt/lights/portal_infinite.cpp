#include "pbrt/lights/portal_infinite.h"

#include <fmt/format.h>

#include "pbrt/lights/image_infinite.h"
#include "pbrt/util/equal_area.h"
#include "pbrt/util/memory.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

/// The two angles of a direction with z > 0, local to the portal, each from 0 to 1 as it goes from
/// -90 to 90 degrees. Planes through the portal's sides and the receiver are lines of one angle.
Point2f AnglesOf(Vector3f w) {
    return {0.5f + std::atan2(w.x, w.z) * InvPi, 0.5f + std::atan2(w.y, w.z) * InvPi};
}
/// The unit direction of two angles.
Vector3f DirectionOf(Point2f angles) {
    const float a = Pi * (angles.x - 0.5f), b = Pi * (angles.y - 0.5f);
    // Along (tan a, tan b, 1).
    return Normalize(
        Vector3f{std::sin(a) * std::cos(b), std::cos(a) * std::sin(b), std::cos(a) * std::cos(b)});
}
/// Solid angle per area of the square of angles, for a unit direction.
float SolidAnglePerArea(Vector3f w) {
    // 1 - x^2 and 1 - y^2, without cancellation.
    return Sqr(Pi) * (Sqr(w.y) + Sqr(w.z)) * (Sqr(w.x) + Sqr(w.z)) / w.z;
}

/// The portal as seen from a place, in angles; nullopt from outside.
std::optional<Window> SeenFrom(const Portal &portal, Point3f from) {
    const Vector3f to = portal.ToLocal(portal.corner - from);
    if (!(to.z > 0)) return std::nullopt;
    return Window{AnglesOf(to), AnglesOf({to.x + portal.width, to.y + portal.height, to.z})};
}

/// Why the points make no portal; empty where they do.
std::string Misshapen(const std::vector<Point3f> &p) {
    if (p.size() != 4) return fmt::format("needs 4 points, not {}", p.size());
    const Vector3f x = p[1] - p[0], y = p[3] - p[0];
    if (!HasSafeLength(x) || !HasSafeLength(y)) return "has a side without length";
    const bool isSkew = std::abs(Dot(Normalize(x), Normalize(y))) > 1e-3f;
    // The fourth point closes the parallelogram.
    if (isSkew || Length(p[2] - p[1] - y) > 1e-3f * (Length(x) + Length(y)))
        return "is no rectangle; its corners go around";
    return {};
}

std::optional<Portal> GetPortal(ParamDict &params, const Transform &renderFromWorld) {
    std::vector<Point3f> corners = params.GetPoint3fArray(PortalInfiniteLight::kPortal);
    for (Point3f &p : corners)
        p = renderFromWorld.Point(p);
    if (const std::string why = Misshapen(corners); !why.empty()) {
        params.Error(PortalInfiniteLight::kPortal.name, fmt::format("\"portal\" {}", why));
        return std::nullopt;
    }
    const Vector3f x = corners[1] - corners[0], y = corners[3] - corners[0];
    // Outward as in pbrt-v4; a mirror turns cross products around.
    const Vector3f z = Normalize(Cross(y, x)) * (renderFromWorld.SwapsHandedness() ? -1.f : 1.f);
    return Portal{corners[0], Normalize(x), Normalize(y), z, Length(x), Length(y)};
}

/// Directions by the picture's strength at four points a cell; and the flux through the portal,
/// which is 0 where it would be below float's least.
void AddDirections(PortalInfiniteLight::Scenery &scenery) {
    constexpr int kLeast = 32;  // of a constant picture
    const int n = std::max(kLeast, scenery.picture.Resolution().x);
    const Portal &portal = scenery.portal;
    std::vector<float> weights;
    weights.reserve(size_t(n) * size_t(n));
    double irradiance = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            float sum = 0;
            for (const float dx : {0.25f, 0.75f})
                for (const float dy : {0.25f, 0.75f}) {
                    const Vector3f w =
                        DirectionOf({(float(x) + dx) / float(n), (float(y) + dy) / float(n)});
                    const Vector3f local =
                        Normalize(scenery.lightFromRender.Vector(portal.FromLocal(w)));
                    const LightPicture &picture = scenery.picture;
                    const float strength =
                        picture.Strength(picture.TexelAt(EqualAreaSphereToSquare(local))) *
                        SolidAnglePerArea(w);
                    sum += strength;
                    irradiance += double(strength * w.z);
                }
            weights.push_back(sum / 4);
        }
    scenery.directions = WindowedDistribution(std::move(weights), n);
    // Strength is twice the greatest component.
    scenery.flux = float(irradiance / 8 / (double(n) * n)) * portal.width * portal.height;
}

std::optional<LightPicture> GetPicture(ParamDict &params) {
    if (params.GetFileName(ImageInfiniteLight::kFileName).empty()) {
        const EmissionScale scale = GetScale(params, kLightIlluminance);
        return LightPicture(GetEmission(params, kLightRadiance), scale.For(Pi));
    }
    const std::optional<SkyPicture> sky = ReadSkyPicture(params);
    if (!sky) return std::nullopt;
    return LightPicture(sky->image, *sky->space, sky->scale);
}

}  // namespace

std::optional<PortalInfiniteLight> PortalInfiniteLight::Create(ParamDict &params,
                                                               const Transform &renderFromLight,
                                                               const Transform &renderFromWorld) {
    const std::optional<Portal> portal = GetPortal(params, renderFromWorld);
    std::optional<LightPicture> picture = GetPicture(params);
    if (!portal || !picture) return std::nullopt;
    Scenery scenery{*std::move(picture), renderFromLight.Inverse(), *portal, {}, 0};
    AddDirections(scenery);
    PortalInfiniteLight light;
    light.scenery = std::make_shared<Scenery>(std::move(scenery));
    return light;
}

std::optional<LightLiSample> PortalInfiniteLight::SampleLi(const LightSampleContext &ctx, Point2f u,
                                                           const SampledWavelengths &lambda) const {
    const Scenery &s = *scenery;
    const std::optional<Window> window = SeenFrom(s.portal, ctx.p);
    if (!window) return std::nullopt;
    const auto drawn = s.directions.Draw(u, *window);
    if (!drawn) return std::nullopt;
    const Vector3f local = DirectionOf(drawn->p);
    const Vector3f wi = s.portal.FromLocal(local);
    const SampledSpectrum L = Le(ctx.p, wi, lambda);
    const float pdf = drawn->pdf / SolidAnglePerArea(local);
    if (!L || !(pdf > 0)) return std::nullopt;
    return LightLiSample{L, wi, pdf, ctx.p + (2 * sceneRadius) * wi, false};
}

SampledSpectrum PortalInfiniteLight::Le(Point3f from, Vector3f d,
                                        const SampledWavelengths &lambda) const {
    const Scenery &s = *scenery;
    const Vector3f to = s.portal.ToLocal(s.portal.corner - from), along = s.portal.ToLocal(d);
    if (!(to.z > 0 && along.z > 0)) return SampledSpectrum(0.f);
    const float t = to.z / along.z;
    const float x = t * along.x - to.x, y = t * along.y - to.y;
    if (!(x >= 0 && x <= s.portal.width && y >= 0 && y <= s.portal.height))
        return SampledSpectrum(0.f);
    const Vector3f w = Normalize(s.lightFromRender.Vector(d));
    return s.picture.Sample(s.picture.TexelAt(EqualAreaSphereToSquare(w)), lambda);
}

float PortalInfiniteLight::PDF_Li(Point3f from, Vector3f wi) const {
    const Scenery &s = *scenery;
    const Vector3f local = s.portal.ToLocal(wi);
    if (!(local.z > 0)) return 0;
    const std::optional<Window> window = SeenFrom(s.portal, from);
    if (!window) return 0;
    const float pdf = s.directions.PDF(AnglesOf(local), *window);
    return pdf > 0 ? pdf / SolidAnglePerArea(local) : 0;
}

}  // namespace pbrt
