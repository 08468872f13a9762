#include "pbrt/integrators/stand_ins.h"

#include <fmt/format.h>

#include <array>

#include "pbrt/integrators/max_depth.h"

namespace pbrt {
namespace {

constexpr std::string_view kNoEffect = "no effect: \"path\" renders";

constexpr BoolParam kVisualizeStrategies{"visualizestrategies", false, kNoEffect};
constexpr BoolParam kVisualizeWeights{"visualizeweights", false, kNoEffect};
constexpr IntParam kBootstrapSamples{"bootstrapsamples", 100000, 1, kMostInt, kNoEffect};
constexpr IntParam kChains{"chains", 1000, 1, kMostInt, kNoEffect};
constexpr IntParam kMutations{"mutationsperpixel", 100, 1, kMostInt,
                              "no effect: the sampler's \"pixelsamples\" counts"};
constexpr FloatParam kLargeStep{"largestepprobability", "", 0.3f, 0, 1, kNoEffect};
constexpr FloatParam kSigma{"sigma", "", 0.01f, kAboveZero, kOpen, kNoEffect};
constexpr IntParam kPhotons{"photonsperiteration", -1, -1, kMostInt, kNoEffect};
constexpr FloatParam kRadius{"radius", "", 1, kAboveZero, kOpen, kNoEffect};
constexpr IntParam kSeed{"seed", 0, kLeastInt, kMostInt, kNoEffect};

// The parameters that have no effect here (PBRT_FORMAT 2.5), by integrator.
void ReadNone(ParamDict &) {}
void ReadBDPT(ParamDict &params) {
    params.GetOneBool(kVisualizeStrategies);
    params.GetOneBool(kVisualizeWeights);
}
void ReadMLT(ParamDict &params) {
    params.GetOneInt(kBootstrapSamples);
    params.GetOneInt(kChains);
    params.GetOneInt(kMutations);
    params.GetOneFloat(kLargeStep);
    params.GetOneFloat(kSigma);
}
void ReadSPPM(ParamDict &params) {
    params.GetOneInt(kPhotons);
    params.GetOneFloat(kRadius);
    params.GetOneInt(kSeed);
}

/// Light that `path` meets with probability 0.
constexpr std::string_view kCaustics =
    "the same picture, but for light of \"point\", \"spot\" and \"distant\" that mirrors and glass "
    "throw on other surfaces (caustics): \"path\" cannot find it";

struct StandIn {
    std::string_view name;
    bool regularizes;  ///< has "regularize"
    void (*readOthers)(ParamDict &);
    std::string_view makes;  ///< what picture it is, for the warning
};
constexpr std::array kStandIns{
    StandIn{"bdpt", true, ReadBDPT, kCaustics},
    StandIn{"mlt", true, ReadMLT, kCaustics},
    StandIn{"sppm", false, ReadSPPM, kCaustics},
    StandIn{"lightpath", false, ReadNone, kCaustics},
    StandIn{"simplevolpath", false, ReadNone,
            "the same picture where there are no media, and surfaces may scatter, too"},
};

}  // namespace

std::vector<std::string_view> StandInNames() {
    std::vector<std::string_view> names;
    for (const StandIn &s : kStandIns)
        names.push_back(s.name);
    return names;
}

std::optional<PathIntegrator> CreateStandIn(std::string_view name, ParamDict &params) {
    for (const StandIn &s : kStandIns) {
        if (s.name != name) continue;
        PathIntegrator path;
        path.maxDepth = params.GetOneInt(kMaxDepth);
        if (s.regularizes) path.regularize = params.GetOneBool(kRegularize);
        s.readOthers(params);
        params.Log().Warning(params.Directive(),
                             fmt::format("integrator \"{}\" is pbrt-v4's and not built here; "
                                         "\"path\" renders in its place: {}",
                                         name, s.makes));
        return path;
    }
    return {};
}

}  // namespace pbrt
