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

/// Takes out of all objects the uses that make one contain itself, depth first.
class InstanceCycles {
  public:
    InstanceCycles(Description *scene, Diagnostics *log) : scene(scene), log(log) {}

    void Visit(const std::string &name) {
        if (done.contains(name)) return;
        above.insert(name);
        std::erase_if(scene->objects.at(name).instances, [this](const InstanceUse &use) {
            if (!above.contains(use.name)) return Visit(use.name), false;
            log->Error(use.loc, fmt::format("object \"{}\" contains itself", use.name));
            return true;
        });
        above.erase(name);
        done.insert(name);
    }

  private:
    Description *scene;
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
    std::set<std::string> reported;
    const auto keepDefined = [&](std::vector<InstanceUse> &uses) {
        std::erase_if(uses, [&](const InstanceUse &use) {
            if (scene->objects.contains(use.name)) return false;
            if (reported.insert(use.name).second)
                log->Error(use.loc, fmt::format("object \"{}\" is not defined{}", use.name,
                                                DidYouMean(use.name, known)));
            return true;
        });
    };
    keepDefined(scene->instances);
    for (auto &[name, object] : scene->objects)
        keepDefined(object.instances);
    InstanceCycles cycles(scene, log);
    for (const auto &[name, object] : scene->objects)
        cycles.Visit(name);
}

}  // namespace pbrt
