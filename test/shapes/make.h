#pragma once

#include <gtest/gtest.h>

#include "pbrt/shapes/shapes.h"
#include "scene/parse.h"

namespace pbrt {

/// The shapes a scene's text describes, and what was said.
struct Made {
    std::vector<Shape> shapes;
    Texts messages;
};

inline Made Make(std::string_view text, std::string_view dir = "") {
    const auto parsed = ParseWorld(text, dir);
    Made made;
    for (const ShapeEntity &entity : parsed->scene.shapes) {
        ParamDict params(entity.params, entity.loc, "shape \"" + entity.type + "\"",
                         entity.colorSpace, &parsed->log, std::string(dir));
        for (Shape &s : CreateShapes(entity, params, entity.worldFromObject[0]))
            made.shapes.push_back(std::move(s));
    }
    made.messages = parsed->Messages();
    return made;
}

/// Of a text that is right and describes one shape.
inline Shape MakeOne(std::string_view text) {
    Made made = Make(text);
    EXPECT_EQ(made.messages, Texts{}) << text;
    EXPECT_EQ(made.shapes.size(), 1u);
    return std::move(made.shapes.at(0));
}

inline Hit HitAt(float t, float u = 0, float v = 0, uint32_t primitive = 0) {
    return {t, u, v, 0, primitive};
}

inline void ExpectNear(Vector3f a, Vector3f b, float tolerance = 2e-6f) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}
inline void ExpectNear(Point2f a, Point2f b, float tolerance = 2e-6f) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

}  // namespace pbrt
