#include "pbrt/integrators/path/shade_groups.h"

#include "pbrt/integrators/path/shade_groups_of.h"

namespace pbrt {

std::span<const ShadeGroup> ShadeGroups() {
    static constexpr auto groups = ShadeGroupsOf<DefaultScattering>();
    return groups;
}

}  // namespace pbrt
