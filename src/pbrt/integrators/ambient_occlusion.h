#pragma once

#include "pbrt/integrators/found_light.h"
#include "pbrt/util/sampling.h"

namespace pbrt {

/// `ambientocclusion`: share of the hemisphere over each visible point, cosine-weighted, in which
/// nothing opaque stands nearer than maxdistance, in the film's white: 1 where nothing does. Lights
/// and materials do not matter, but for null transmission: gaps let as much through as they do of
/// light. cossample: directions are drawn by their weight, else evenly.
class AmbientOcclusionIntegrator {
  public:
    static constexpr std::string_view kName = "ambientocclusion";
    static constexpr IntegratorTraits kTraits{.usesLights = false};
    static constexpr BoolParam kCosSample{"cossample", true,
                                          "directions are drawn by their weight, else evenly"};
    static constexpr FloatParam kMaxDistance{
        "maxdistance", "", kOpen, 0, kOpen, "what is farther does not occlude"};

    static AmbientOcclusionIntegrator Create(ParamDict &params) {
        AmbientOcclusionIntegrator i;
        i.cosSample = params.GetOneBool(kCosSample);
        i.maxDistance = params.GetOneFloat(kMaxDistance);
        return i;
    }
    void Preprocess(const RenderScene &scene) {
        const Spectrum &illuminant = scene.film.ColorSpace().Illuminant();
        white = illuminant.Scaled(1 / SpectrumToPhotometric(illuminant));
    }

    template <typename SamplerT>
    SampledSpectrum Li(const RenderScene &scene, Ray ray, SampledWavelengths *lambda,
                       SamplerT *sampler, RayCounts *counts) const {
        Hit hit;
        ++counts->closest;
        if (!scene.accel->Intersect(ray, &hit)) return SampledSpectrum(0);
        const SurfaceInteraction sp = scene.SurfaceAt(hit, ray);
        const Point2f u = sampler->Get2D();
        const Vector3f local = cosSample ? SampleCosineHemisphere(u) : SampleUniformHemisphere(u);
        const Vector3f d = Frame::FromZ(FaceForward(sp.n, -ray.d)).FromLocal(local);
        const float weight = cosSample ? 1 : 2 * local.z;
        return white.Sample(*lambda) *
               (weight * OpenShare(scene, sp.OffsetOrigin(d), d, ray.time, counts));
    }

  private:
    float OpenShare(const RenderScene &scene, Point3f o, Vector3f d, float time,
                    RayCounts *counts) const {
        ++counts->shadow;
        const Ray ray{o, d, maxDistance, time};
        if (scene.accel->HasNullTransmission())
            return scene.accel->Transmittance(ray, NullTransmissionOf(scene));
        return scene.accel->Occluded(ray) ? 0 : 1;
    }

    bool cosSample = true;
    float maxDistance = Infinity;
    Spectrum white;  ///< of luminance 1
};

}  // namespace pbrt
