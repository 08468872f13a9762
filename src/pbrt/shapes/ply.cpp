#include "pbrt/shapes/create.h"

namespace pbrt {

std::vector<Shape> CreatePlyMesh(const ShapeArguments &a) {
    a.params.Error("shape \"plymesh\" cannot be read yet");
    return {};
}

}  // namespace pbrt
