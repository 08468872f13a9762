#include "pbrt/integrators/integrators.h"

#include <fmt/format.h>

#include "pbrt/integrators/one_by_one.h"
#include "pbrt/integrators/stand_ins.h"

namespace pbrt {
namespace {

/// Without media `volpath` is `path`.
constexpr std::string_view kVolPath = "volpath";

}  // namespace

std::vector<std::string_view> IntegratorNames() {
    std::vector<std::string_view> names{kVolPath};
    names.insert(names.end(), IntegratorTypes::kNames.begin(), IntegratorTypes::kNames.end());
    for (const std::string_view name : StandInNames())
        names.push_back(name);
    return names;
}

Integrator CreateIntegrator(const SceneDescription &description, Diagnostics &log) {
    const Entity &entity = description.integrator;
    const std::string name = entity.type.empty() ? std::string(kVolPath) : entity.type;
    ParamDict params(entity.params, entity.loc, fmt::format("integrator \"{}\"", name),
                     entity.colorSpace, &log, description.dir);
    return CreateIntegrator(name, params);
}

Integrator CreateIntegrator(std::string_view name, ParamDict &params) {
    Integrator integrator;
    bool known = IntegratorTypes::Visit(name == kVolPath ? PathIntegrator::kName : name,
                                        [&]<typename I>() { integrator = I::Create(params); });
    if (auto path = CreateStandIn(name, params)) {
        integrator = std::move(*path);
        known = true;
    }
    if (known)
        params.ReportUnused();
    else
        params.Error(UnknownName("integrator", name, IntegratorNames()));
    return integrator;
}

std::unique_ptr<Tracer> MakeTracer(const Integrator &integrator, const RenderScene &scene) {
    return Dispatch(integrator, [&]<typename I>(const I &i) -> std::unique_ptr<Tracer> {
        if constexpr (I::kTraits.tracesBatches)
            return i.MakeTracer(scene);
        else
            return Dispatch(scene.sampler, [&]<typename S>(const S &s) -> std::unique_ptr<Tracer> {
                return std::make_unique<OneByOneTracer<I, S>>(scene, i, s);
            });
    });
}

}  // namespace pbrt
