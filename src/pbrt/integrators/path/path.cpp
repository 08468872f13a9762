#include "pbrt/integrators/path/path.h"

#include <algorithm>
#include <array>

#include "pbrt/integrators/max_depth.h"
#include "pbrt/integrators/path/batch_tracer.h"

namespace pbrt {
namespace {

/// pbrt-v4's name for `bvh` without a tree: it weighs all lights at each vertex.
constexpr std::string_view kExhaustive = "exhaustive";
constexpr std::array<std::string_view, kLightSamplerNames.size() + 1> kChoices = [] {
    std::array<std::string_view, kLightSamplerNames.size() + 1> choices;
    std::copy(kLightSamplerNames.begin(), kLightSamplerNames.end(), choices.begin());
    choices.back() = kExhaustive;
    return choices;
}();
constexpr ChoiceParam kLightSampler{"lightsampler", kChoices[0], kChoices,
                                    "how one light of many is chosen; exhaustive: as bvh"};

}  // namespace

PathIntegrator PathIntegrator::Create(ParamDict &params) {
    PathIntegrator i;
    i.maxDepth = params.GetOneInt(kMaxDepth);
    i.regularize = params.GetOneBool(kRegularize);
    const std::string_view choice = kChoices[size_t(params.GetOneChoice(kLightSampler))];
    if (choice == kExhaustive)
        params.Warning(kLightSampler.name,
                       "\"lightsampler\" \"exhaustive\" is pbrt-v4's and not built here; \"bvh\" "
                       "chooses in its place: the same picture with other noise");
    else
        i.lightSamplerName = choice;
    return i;
}

std::unique_ptr<Tracer> PathIntegrator::MakeTracer(const RenderScene &scene) const {
    return Dispatch(scene.sampler, [&]<typename S>(const S &sampler) -> std::unique_ptr<Tracer> {
        return std::make_unique<BatchTracer<S>>(scene, *this, sampler);
    });
}

}  // namespace pbrt
