#include "pbrt/integrators/path/path.h"

#include "pbrt/integrators/path/batch_tracer.h"

namespace pbrt {

PathIntegrator PathIntegrator::Create(ParamDict &params) {
    PathIntegrator i;
    i.maxDepth = params.GetOneInt("maxdepth", 5, 0, 1 << 20);
    i.regularize = params.GetOneBool("regularize", false);
    const int which = params.GetOneChoice("lightsampler", "bvh", kLightSamplerNames);
    i.lightSamplerName = kLightSamplerNames[size_t(which)];
    return i;
}

std::unique_ptr<Tracer> PathIntegrator::MakeTracer(const RenderScene &scene) const {
    return Dispatch(scene.sampler, [&]<typename S>(const S &sampler) -> std::unique_ptr<Tracer> {
        return std::make_unique<BatchTracer<S>>(scene, *this, sampler);
    });
}

}  // namespace pbrt
