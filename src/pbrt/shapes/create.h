#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pbrt/scene/description.h"
#include "pbrt/shapes/types.h"

namespace pbrt {

/// What every shape's maker is given.
struct ShapeArguments {
    const ShapeEntity &entity;
    ParamDict &params;
    const Transform &renderFromObject;
};

// One maker per shape name; empty after an error.
std::vector<Shape> CreateTriangleMesh(const ShapeArguments &a);
std::vector<Shape> CreateBilinearMesh(const ShapeArguments &a);
std::vector<Shape> CreatePlyMesh(const ShapeArguments &a);
std::vector<Shape> CreateSphere(const ShapeArguments &a);
std::vector<Shape> CreateDisk(const ShapeArguments &a);
std::vector<Shape> CreateCylinder(const ShapeArguments &a);
std::vector<Shape> CreateCurve(const ShapeArguments &a);

/// Moves a mesh in object space to rendering space, orients its normals, and leaves room for the
/// 16-byte reads of Embree behind the last vertex. What is wrong with it, or nothing.
std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     TriangleMesh *mesh);
std::optional<std::string> PlaceMesh(const Transform &renderFromObject, bool reverseOrientation,
                                     BilinearMesh *mesh);

}  // namespace pbrt
