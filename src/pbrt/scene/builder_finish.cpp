#include <fmt/format.h>

#include <algorithm>
#include <map>
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

/// Takes out the uses that `keep`, asked once for each, in order, refuses.
template <typename F>
void KeepIf(PackedEntities<InstanceUse> &uses, F keep) {
    std::vector<bool> kept;
    for (const InstanceUse &use : uses)
        kept.push_back(keep(use));
    if (std::find(kept.begin(), kept.end(), false) == kept.end()) return;
    PackedEntities<InstanceUse> left;
    for (const bool k : kept)
        if (const InstanceUse &use = uses.Take(); k) left.Append(use);
    uses = std::move(left);
}

/// Deepest nesting of objects: code that goes through objects inside objects recurs for each level.
constexpr int kMostLevels = 1000;

/// Takes out of all objects the uses that make one contain itself, or too many levels, depth first.
class InstanceCycles {
  public:
    InstanceCycles(SceneDescription *scene, Diagnostics *log) : scene(scene), log(log) {}

    /// The levels of objects in this one, itself counted.
    int Visit(const std::string &name) {
        const auto known = levels.find(name);
        if (known != levels.end()) return known->second;
        above.insert(name);
        int deepest = 0;
        KeepIf(scene->objects.at(name).instances, [&](const InstanceUse &use) {
            if (above.contains(use.name)) {
                log->Error(use.loc, fmt::format("object \"{}\" contains itself", use.name));
                return false;
            }
            const int inner = int(above.size()) < kMostLevels ? Visit(use.name) : kMostLevels;
            if (inner < kMostLevels) {
                deepest = std::max(deepest, inner);
                return true;
            }
            log->Error(use.loc, fmt::format("objects are nested more than {} deep", kMostLevels));
            return false;
        });
        above.erase(name);
        return levels[name] = 1 + deepest;
    }

  private:
    SceneDescription *scene;
    Diagnostics *log;
    std::set<std::string> above;
    std::map<std::string, int> levels;
};

}  // namespace

void SceneBuilder::Finish() {
    ReportUnclosed();
    CheckMaterialUses();
    CheckMediumUses();
    CheckInstanceUses();
}

void SceneBuilder::CheckMediumUses() {
    const std::vector<std::string_view> known = Names(media);
    for (const std::string_view name : Names(mediumUses))
        if (!media.contains(std::string(name)))
            log->Error(
                mediumUses.at(std::string(name)),
                fmt::format("medium \"{}\" is not defined{}", name, DidYouMean(name, known)));
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
    const auto keepDefined = [&](PackedEntities<InstanceUse> &uses) {
        KeepIf(uses, [&](const InstanceUse &use) {
            if (scene->objects.contains(use.name)) return true;
            if (reported.insert(use.name).second)
                log->Error(use.loc, fmt::format("object \"{}\" is not defined{}", use.name,
                                                DidYouMean(use.name, known)));
            return false;
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
