#include <fmt/format.h>

#include <set>

#include "pbrt/scene/builder.h"

namespace pbrt {
namespace {

template <typename Map>
std::vector<std::string_view> Names(const Map &map) {
    std::vector<std::string_view> names;
    for (const auto &entry : map)
        names.push_back(entry.first);
    std::sort(names.begin(), names.end());
    return names;
}

/// Finds objects that contain themselves, depth first.
class InstanceCycles {
  public:
    InstanceCycles(const Description &scene, Diagnostics *log) : scene(scene), log(log) {}

    void Visit(const std::string &name) {
        if (done.contains(name)) return;
        const auto object = scene.objects.find(name);
        if (object == scene.objects.end()) return;
        above.insert(name);
        for (const InstanceUse &use : object->second.instances) {
            if (above.contains(use.name))
                log->Error(use.loc, fmt::format("object \"{}\" contains itself", use.name));
            else
                Visit(use.name);
        }
        above.erase(name);
        done.insert(name);
    }

  private:
    const Description &scene;
    Diagnostics *log;
    std::set<std::string> above, done;
};

}  // namespace

void SceneBuilder::Finish() {
    ReportUnclosed();
    CheckMaterialUses();
    CheckInstanceUses();
}

void SceneBuilder::CheckMaterialUses() {
    const std::vector<std::string_view> known = Names(namedMaterials);
    std::set<std::string_view> reported;
    for (const auto &[name, loc] : materialUses)
        if (!namedMaterials.contains(name) && reported.insert(name).second)
            log->Error(loc, fmt::format("material \"{}\" is not defined{}", name,
                                        DidYouMean(name, known)));
}

void SceneBuilder::CheckInstanceUses() {
    const std::vector<std::string_view> known = Names(scene->objects);
    std::set<std::string_view> reported;
    const auto check = [&](const std::vector<InstanceUse> &uses) {
        for (const InstanceUse &use : uses)
            if (!scene->objects.contains(use.name) && reported.insert(use.name).second)
                log->Error(use.loc, fmt::format("object \"{}\" is not defined{}", use.name,
                                                DidYouMean(use.name, known)));
    };
    check(scene->instances);
    InstanceCycles cycles(*scene, log);
    for (const auto &[name, object] : scene->objects) {
        check(object.instances);
        cycles.Visit(name);
    }
}

}  // namespace pbrt
