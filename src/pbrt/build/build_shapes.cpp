#include "pbrt/build/build_shapes.h"

#include <fmt/format.h>

#include "pbrt/build/instance_range.h"
#include "pbrt/util/memory.h"
#include "pbrt/util/motion.h"

namespace pbrt {
namespace {

/// Bytes that the ray tracer and RenderScene::instances take for one that rests, where there are
/// many: 970 MiB were measured for 3.2 million.
constexpr double kBytesPerInstance = 320;
/// Geometries and instances share numbers of 32 bits.
constexpr double kMostIds = 4e9;
constexpr FloatParam kAlpha{"alpha", "", 1,
                            0,       1,  "coverage of the surface: below 1 is a random cut-out"};

/// A mesh of several faces whose uv are not given: each face has those of its own corners.
bool LacksUV(const Shape &shape) {
    const auto lacks = [](const auto &mesh) { return mesh.uv.empty() && mesh.NPrimitives() > 1; };
    if (const auto *triangles = std::get_if<TriangleMesh>(&shape)) return lacks(*triangles);
    const auto *patches = std::get_if<BilinearMesh>(&shape);
    return patches && lacks(*patches);
}

bool HasTangents(const Shape &shape) {
    const auto *triangles = std::get_if<TriangleMesh>(&shape);
    return triangles && !triangles->s.empty();
}

/// Builds geometries; keeps what the many shapes of a scene have in common.
class ShapeBuilder {
  public:
    ShapeBuilder(SceneDescription &description, const NamedTextures &textures,
                 const MaterialTable &materials, RenderScene &scene, Diagnostics &log)
        : description(description),
          textures(textures),
          materials(materials),
          scene(scene),
          log(log) {}

    void Add(const ShapeEntity &entity, const Transform &renderFromObject, bool instanced) {
        ParamDict params(entity.params, entity.loc, fmt::format("shape \"{}\"", entity.type),
                         entity.colorSpace, &log, description.dir);
        const FloatTexture alpha = GetAlpha(params, textures);
        std::vector<Shape> shapes = CreateShapes(entity, params, renderFromObject, textures);
        const MaterialId material = MaterialOf(entity);
        if (material == kInterfaceId) {
            if (entity.areaLight)
                log.Warning(entity.loc, "an area light on an interface gives no light");
            return;
        }
        for (const Shape &shape : shapes)
            if (LacksUV(shape)) WarnOfMissingUV(entity, material, HasTangents(shape));
        for (Shape &shape : shapes) {
            Geometry geometry;
            geometry.shape = std::move(shape);
            geometry.material = std::max(0, material);
            geometry.alpha = alpha;
            geometry.hasNullTransmission = scene.HasNullTransmission(material);
            if (instanced) objectBounds.Grow(Bounds(geometry.shape));
            if (entity.areaLight && !CanEmit(geometry.shape)) {
                log.Error(entity.loc, "a curve cannot be an area light");
                continue;
            }
            if (entity.areaLight)
                built.emitters.push_back({uint32_t(scene.geometries.size()), entity.areaLight});
            if (!JoinCurves(geometry)) scene.geometries.push_back(std::move(geometry));
        }
    }

    /// From here on shapes belong to another object.
    uint32_t StartObject() {
        objectBounds = {};
        return joinFrom = uint32_t(scene.geometries.size());
    }

    /// Every use of an object, with the uses inside it, as one-deep instances. The parser has seen
    /// to it that the object exists and does not contain itself.
    void AddInstance(const InstanceUse &use, const TransformPair &renderFromParent,
                     const FileLoc &loc) {
        if (InstancesOf(use.name) == 0) return;  // there may be 2^30 ways to nothing
        const ObjectEntity &object = description.objects.at(use.name);
        TransformPair t;
        for (int i = 0; i < 2; ++i)
            t[i] = renderFromParent[i] * use.worldFromInstance[i];
        for (const ObjectPart &part : parts.at(use.name))
            Place(part, {t[0] * part.inObject[0], t[1] * part.inObject[1]}, loc);
        for (const InstanceUse &inner : object.instances)
            AddInstance(inner, t, loc);
    }

    /// Takes the uses of the top level; refused where with all inside them they are more than fit.
    void AddInstances(PackedEntities<InstanceUse> &uses, const Transform &renderFromWorld) {
        double total = 0, most = 0;
        FileLoc where;
        for (const InstanceUse &use : uses) {
            const double n = InstancesOf(use.name);
            total += n;
            if (n <= most) continue;
            most = n;
            where = use.loc;
        }
        if (const auto why = WhyTooMany(total)) {
            log.Error(where, fmt::format("{:.6g} instances with those inside objects, {:.6g} of "
                                         "them by this one: the scene {}",
                                         total, most, *why));
            return;
        }
        scene.instances.reserve(size_t(total));
        built.instances.Reserve(size_t(total));
        while (!uses.empty()) {
            const InstanceUse &use = uses.Take();
            AddInstance(use, {renderFromWorld, renderFromWorld}, use.loc);
        }
        uses = {};
    }

    void AddObjects() {
        for (auto &[name, object] : description.objects) {
            std::vector<ObjectPart> &made = parts[name];
            const uint32_t first = StartObject();
            const std::vector<ShapeEntity> moving = AddResting(object.shapes, nullptr);
            made.push_back(FinishObject(first, {}));
            for (const ShapeEntity &entity : moving)
                made.push_back(AddMovingShape(entity));
        }
    }

    /// Takes the shapes and returns those that move. `renderFromWorld`: null for an object's.
    std::vector<ShapeEntity> AddResting(PackedEntities<ShapeEntity> &shapes,
                                        const Transform *renderFromWorld) {
        std::vector<ShapeEntity> moving;
        while (!shapes.empty()) {
            const ShapeEntity &entity = shapes.Take();
            const Transform &t = entity.worldFromObject[0];
            if (Moves(entity))
                moving.push_back(entity);
            else
                Add(entity, renderFromWorld ? *renderFromWorld * t : t, !renderFromWorld);
        }
        shapes = {};
        return moving;
    }

    void AddMovingShapes(const std::vector<ShapeEntity> &shapes, const Transform &renderFromWorld) {
        for (const ShapeEntity &entity : shapes) {
            const TransformPair &t = entity.worldFromObject;
            const size_t emitters = built.emitters.size();
            Place(AddMovingShape(entity), {renderFromWorld * t[0], renderFromWorld * t[1]},
                  entity.loc);
            for (size_t i = emitters; i < built.emitters.size(); ++i)
                built.emitters[i].instance = int(scene.instances.size()) - 1;
        }
    }

    BuiltShapes built;

  private:
    static bool Moves(const ShapeEntity &entity) {
        return !(entity.worldFromObject[0] == entity.worldFromObject[1]);
    }
    /// Part of an object: its resting shapes together, or one moving shape.
    struct ObjectPart {
        uint32_t object;  ///< index into RenderScene::objects
        TransformPair inObject;
        Bounds3f bounds;
    };

    ObjectPart FinishObject(uint32_t first, const TransformPair &inObject) {
        scene.objects.push_back({first, uint32_t(scene.geometries.size())});
        return {uint32_t(scene.objects.size()) - 1, inObject, objectBounds};
    }
    /// A shape whose two transforms differ becomes an object of its own, made in its own space; an
    /// instance carries the motion.
    ObjectPart AddMovingShape(const ShapeEntity &entity) {
        const uint32_t first = StartObject();
        Add(entity, Transform(), true);
        return FinishObject(first, entity.worldFromObject);
    }
    std::optional<std::string> WhyTooMany(double instances) const {
        if (instances + double(scene.geometries.size()) > kMostIds)
            return fmt::format("may have {:.0f}", kMostIds);
        return WhyTooLarge(uint64_t(instances * kBytesPerInstance));
    }
    /// Instances that one use makes with those inside it, at most.
    double InstancesOf(const std::string &name) {
        const auto known = instancesOf.find(name);
        if (known != instancesOf.end()) return known->second;
        double n = 0;
        for (const ObjectPart &part : parts.at(name)) {
            const ObjectRange &range = scene.objects[part.object];
            n += range.first < range.last;
        }
        for (const InstanceUse &inner : description.objects.at(name).instances)
            n += InstancesOf(inner.name);
        return instancesOf[name] = n;
    }
    void Place(const ObjectPart &part, const TransformPair &renderFromObject, const FileLoc &loc) {
        const ObjectRange &range = scene.objects[part.object];
        if (range.first == range.last) return;
        for (const Transform &t : renderFromObject)
            if (!IsAffine(t))
                return log.Error(loc,
                                 "this cannot be placed: its transformation is a perspective one");
        Instance instance{part.object, AffineTransform(renderFromObject[0])};
        if (!(renderFromObject[0] == renderFromObject[1])) {
            scene.isAnimated = true;
            std::vector<Transform> later = KeysBetween(renderFromObject[0], renderFromObject[1]);
            later.push_back(renderFromObject[1]);
            instance.later = std::make_unique<const std::vector<Transform>>(std::move(later));
        }
        if (const auto why = WhyNotPlaced(instance, part.bounds))
            return log.Error(loc, fmt::format("this cannot be placed: {}", *why));
        scene.instances.push_back(std::move(instance));
        built.instances.Append(loc);
    }

    void WarnOfMissingUV(const ShapeEntity &entity, MaterialId material, bool hasTangents) {
        std::string_view laid;
        if (materials.texturedByUV.contains(material) || textures.AnyReadsUV(entity.params))
            laid = "textures";
        if (const auto found = materials.laidByUV.find(material);
            found != materials.laidByUV.end() && !hasTangents)
            laid = found->second;
        if (laid.empty()) return;
        log.Warning(entity.loc,
                    fmt::format("shape \"{}\" has no uv: {} are laid by each face's own "
                                "corners",
                                entity.type, laid));
    }

    /// The parser has reported names that are not defined.
    MaterialId MaterialOf(const ShapeEntity &entity) {
        if (!entity.namedMaterial.empty()) {
            const auto named = materials.named.find(entity.namedMaterial);
            return named == materials.named.end() ? materials.fallback : named->second;
        }
        return entity.material < 0 ? materials.fallback : materials.unnamed[entity.material];
    }

    /// Adds curves to those of the last geometry where nothing tells them apart: hairs are single
    /// shapes in a scene file, and a geometry costs more than a hair.
    bool JoinCurves(Geometry &geometry) {
        if (scene.geometries.size() <= joinFrom) return false;
        Geometry &last = scene.geometries.back();
        auto *const into = std::get_if<CurveSet>(&last.shape);
        auto *const more = std::get_if<CurveSet>(&geometry.shape);
        const auto hasOneAlpha = [](const Geometry &g) { return g.alpha.IsConstant(); };
        if (!into || !more || last.material != geometry.material || !hasOneAlpha(last) ||
            !hasOneAlpha(geometry) || last.alpha.Constant() != geometry.alpha.Constant())
            return false;
        return Append(*more, into);
    }

    SceneDescription &description;
    const NamedTextures &textures;
    const MaterialTable &materials;
    RenderScene &scene;
    Diagnostics &log;
    uint32_t joinFrom = 0;  ///< first geometry of the object being built
    Bounds3f objectBounds;  ///< of that object
    std::map<std::string, std::vector<ObjectPart>> parts;  ///< by the object's name
    std::map<std::string, double> instancesOf;             ///< see InstancesOf
};

}  // namespace

FloatTexture GetAlpha(ParamDict &params, const NamedTextures &textures) {
    return GetFloatTexture(params, textures, kAlpha);
}

BuiltShapes BuildShapes(SceneDescription &description, const NamedTextures &textures,
                        const MaterialTable &materials, RenderScene &scene, Diagnostics &log) {
    scene.geometries.reserve(description.shapes.size());  // growing, they would be there twice
    ShapeBuilder builder(description, textures, materials, scene, log);
    const Transform &renderFromWorld = Placement(scene.camera).renderFromWorld;
    const std::vector<ShapeEntity> moving =
        builder.AddResting(description.shapes, &renderFromWorld);
    builder.AddObjects();
    builder.AddMovingShapes(moving, renderFromWorld);
    builder.AddInstances(description.instances, renderFromWorld);
    return std::move(builder.built);
}

}  // namespace pbrt
