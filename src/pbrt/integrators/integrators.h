#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "pbrt/integrators/ambient_occlusion.h"
#include "pbrt/integrators/path/path.h"
#include "pbrt/integrators/random_walk.h"
#include "pbrt/integrators/simple_path.h"
#include "pbrt/integrators/tracer.h"
#include "pbrt/util/type_list.h"

namespace pbrt {

/// The one list of integrators; base/integrator.h has their contract.
using IntegratorTypes = TypeList<PathIntegrator, SimplePathIntegrator, RandomWalkIntegrator,
                                 AmbientOcclusionIntegrator>;
static_assert(IntegratorTypes::All([]<typename I>() { return IntegratorType<I>; }));
using Integrator = IntegratorTypes::Variant;

/// The integrator that the scene names, pbrt's default `volpath` where it names none. Mistakes go
/// to the log, and a default is returned.
Integrator CreateIntegrator(const SceneDescription &description, Diagnostics &log);
/// The same by its name and parameters.
Integrator CreateIntegrator(std::string_view name, ParamDict &params);
std::unique_ptr<Tracer> MakeTracer(const Integrator &integrator, const RenderScene &scene);
/// All of IntegratorTypes, `volpath`, and those that `path` stands in for (stand_ins.h).
std::vector<std::string_view> IntegratorNames();

}  // namespace pbrt
