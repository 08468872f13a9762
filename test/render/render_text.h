#pragma once

#include <gtest/gtest.h>

#include <string>

#include "pbrt/render/render.h"

namespace pbrt::test {

/// What a test changes of a scene beside its text.
struct RenderChanges {
    int nThreads = 0;
    int seed = 0;
    std::optional<int> spp = std::nullopt;
    LightStrategy strategy = LightStrategy::Both;  ///< of the path integrator
};

inline bool GoOn(int64_t, int64_t) {
    return true;
}

struct Rendered {
    Image image;
    RenderStats stats;
};
inline Rendered RenderAll(const RenderTask &task, int nThreads = 0) {
    Rendered r;
    const auto stats = Render(task, nThreads, GoOn, &r.image);
    EXPECT_TRUE(stats);
    if (stats) r.stats = *stats;
    return r;
}

/// Renders scene text; relative files start from the folder `dir`. Mistakes in it fail the test.
inline Image RenderText(const std::string &text, const RenderChanges &changes = {},
                        const std::string &dir = ".") {
    Diagnostics log;
    SceneDescription description;
    description.options.seed = changes.seed;
    ParseString(text, "test.pbrt", dir, description, log);
    Overrides overrides;
    overrides.spp = changes.spp;
    std::optional<RenderTask> task = MakeRenderTask(std::move(description), overrides, log);
    for (const Message &m : log.Messages())
        if (m.severity == Severity::Error) ADD_FAILURE() << m.text;
    if (!task) return {};
    if (auto *const path = std::get_if<PathIntegrator>(&task->integrator))
        path->strategy = changes.strategy;
    return RenderAll(*task, changes.nThreads).image;
}

inline std::array<double, 3> Mean(const Image &image) {
    std::array<double, 3> sum{};
    const Point2i n = image.Resolution();
    for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += image.Get({x, y}, c);
    for (double &s : sum)
        s /= double(n.x) * n.y;
    return sum;
}

}  // namespace pbrt::test
