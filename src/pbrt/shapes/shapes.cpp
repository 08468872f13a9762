#include "pbrt/shapes/shapes.h"

#include <fmt/format.h>

#include "pbrt/util/check.h"
#include "pbrt/util/range.h"

namespace pbrt {
namespace {

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

// What a Create may return, added to all shapes.

template <ShapeType S>
void Add(S made, std::vector<Shape> *shapes) {
    shapes->emplace_back(std::move(made));
}
template <typename... S>
void Add(std::variant<S...> made, std::vector<Shape> *shapes) {
    Dispatch(made, [&](auto &one) { Add(std::move(one), shapes); });
}
template <typename Made>
void Add(std::optional<Made> made, std::vector<Shape> *shapes) {
    if (made) Add(std::move(*made), shapes);
}
template <typename Made>
void Add(std::vector<Made> made, std::vector<Shape> *shapes) {
    for (Made &one : made)
        Add(std::move(one), shapes);
}

/// f(shape) for the shapes that can emit, which is all that may be given.
template <typename F>
auto DispatchEmitting(const Shape &shape, F f) {
    using Result = decltype(f(std::declval<const TriangleMesh &>()));
    return Dispatch(shape, [&]<typename S>(const S &s) -> Result {
        if constexpr (S::kTraits.canEmit) return f(s);
        DCHECK(S::kTraits.canEmit);
        return {};
    });
}

}  // namespace

std::vector<Shape> CreateShapes(const ShapeEntity &entity, ParamDict &params,
                                const Transform &renderFromObject, const NamedTextures &textures) {
    std::vector<Shape> shapes;
    const bool known = ShapeDirectives::Visit(entity.type, [&]<typename S>() {
        Add(S::Create({entity, params, renderFromObject, textures}), &shapes);
    });
    if (!known) {
        params.Error(UnknownName("shape", entity.type, ShapeDirectives::kNames));
        return {};
    }
    shapes = InRange(std::move(shapes), params);
    params.ReportUnused();
    return shapes;
}

size_t NPrimitives(const Shape &shape) {
    return Dispatch(shape, [](const auto &s) { return s.NPrimitives(); });
}
Bounds3f Bounds(const Shape &shape) {
    return Dispatch(shape, [](const auto &s) { return s.Bounds(); });
}
Bounds3f PrimitiveBounds(const Shape &shape, uint32_t primitive) {
    return Dispatch(shape, [&](const auto &s) { return s.PrimitiveBounds(primitive); });
}

bool CanEmit(const Shape &shape) {
    return Dispatch(shape, []<typename S>(const S &) { return S::kTraits.canEmit; });
}
float Area(const Shape &shape, uint32_t primitive) {
    return DispatchEmitting(shape, [&](const auto &s) { return s.Area(primitive); });
}
std::optional<ShapeSample> SampleArea(const Shape &shape, uint32_t primitive, Point2f u) {
    return DispatchEmitting(shape, [&](const auto &s) { return s.SampleArea(primitive, u); });
}
std::optional<ShapeSample> SampleFrom(const Shape &shape, uint32_t primitive, Point3f ref,
                                      Point2f u) {
    return DispatchEmitting(shape, [&](const auto &s) { return s.SampleFrom(primitive, ref, u); });
}
float PDFFrom(const Shape &shape, uint32_t primitive, Point3f ref, Point3f p, Normal3f n) {
    return DispatchEmitting(shape, [&](const auto &s) { return s.PDFFrom(primitive, ref, p, n); });
}
NormalCone NormalBounds(const Shape &shape, uint32_t primitive) {
    return DispatchEmitting(shape, [&](const auto &s) { return s.NormalBounds(primitive); });
}

}  // namespace pbrt
