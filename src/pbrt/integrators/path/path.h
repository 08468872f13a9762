#pragma once

#include "pbrt/base/integrator.h"
#include "pbrt/integrators/path/settings.h"

namespace pbrt {

/// `path`, and `volpath` where there are no media: unidirectional path tracing with multiple
/// importance sampling and Russian roulette, sixteen paths side by side.
///   settings.h          what a scene sets
///   batch_tracer.h      takes a batch of paths from vertex to vertex: the place to start reading
///   surface_vertices.h  what happens at sixteen vertices
///   emission.h          light that paths meet
///   path_state.h, path_queue.h, path_batch.h    what paths carry
///   surface_bsdfs.h     the BSDFs of sixteen surfaces
class PathIntegrator : public PathSettings {
  public:
    static constexpr std::string_view kName = "path";
    static constexpr IntegratorTraits kTraits{.tracesBatches = true};

    static PathIntegrator Create(ParamDict &params);
    std::unique_ptr<Tracer> MakeTracer(const RenderScene &scene) const;
};

}  // namespace pbrt
