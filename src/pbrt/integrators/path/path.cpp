#include "pbrt/integrators/path/path.h"

#include "pbrt/integrators/max_depth.h"
#include "pbrt/integrators/path/batch_tracer.h"

namespace pbrt {
namespace {

constexpr BoolParam kRegularize{"regularize", false,
                                "surfaces are rougher after a path's first rough one"};
constexpr ChoiceParam kLightSampler{"lightsampler", kLightSamplerNames[0], kLightSamplerNames,
                                    "how one light of many is chosen"};

}  // namespace

PathIntegrator PathIntegrator::Create(ParamDict &params) {
    PathIntegrator i;
    i.maxDepth = params.GetOneInt(kMaxDepth);
    i.regularize = params.GetOneBool(kRegularize);
    const int which = params.GetOneChoice(kLightSampler);
    i.lightSamplerName = kLightSamplerNames[size_t(which)];
    return i;
}

std::unique_ptr<Tracer> PathIntegrator::MakeTracer(const RenderScene &scene) const {
    return Dispatch(scene.sampler, [&]<typename S>(const S &sampler) -> std::unique_ptr<Tracer> {
        return std::make_unique<BatchTracer<S>>(scene, *this, sampler);
    });
}

}  // namespace pbrt
