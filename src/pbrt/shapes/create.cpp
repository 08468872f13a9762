#include "pbrt/shapes/create.h"

#include <fmt/format.h>

#include <array>

#include "pbrt/shapes/shape.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

struct ShapeType {
    std::string_view name;
    std::vector<Shape> (*create)(const ShapeArguments &);
};
constexpr std::array kTypes{ShapeType{"trianglemesh", CreateTriangleMesh},
                            ShapeType{"plymesh", CreatePlyMesh},
                            ShapeType{"bilinearmesh", CreateBilinearMesh},
                            ShapeType{"sphere", CreateSphere},
                            ShapeType{"disk", CreateDisk},
                            ShapeType{"cylinder", CreateCylinder},
                            ShapeType{"curve", CreateCurve}};

constexpr auto kNames = [] {
    std::array<std::string_view, kTypes.size()> names;
    for (size_t i = 0; i < names.size(); ++i)
        names[i] = kTypes[i].name;
    return names;
}();

/// Traversal would leave out what lies too far off.
std::vector<Shape> InRange(std::vector<Shape> shapes, ParamDict &params) {
    for (const Shape &shape : shapes) {
        const Bounds3f b = Bounds(shape);
        if (b.Empty() || IsInRange(b)) continue;
        params.Error(fmt::format("{} reaches to {:g}; only coordinates up to {:g} can be traced",
                                 params.What(), Reach(b), kFarthest));
        return {};
    }
    return shapes;
}

}  // namespace

std::span<const std::string_view> ShapeNames() {
    return kNames;
}

std::vector<Shape> CreateShapes(const ShapeEntity &entity, ParamDict &params,
                                const Transform &renderFromObject) {
    for (const ShapeType &type : kTypes)
        if (type.name == entity.type) {
            std::vector<Shape> shapes =
                InRange(type.create({entity, params, renderFromObject}), params);
            params.ReportUnused();
            return shapes;
        }
    params.Error(UnknownName("shape", entity.type, kNames));
    return {};
}

}  // namespace pbrt
