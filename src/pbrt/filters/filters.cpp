#include "pbrt/filters/filters.h"

namespace pbrt {

std::optional<Filter> CreateFilter(ParamDict &params, std::string_view type) {
    std::optional<Filter> filter;
    const bool known =
        FilterTypes::Visit(type, [&]<typename F>() { filter.emplace(F::Create(params)); });
    if (!known) {
        params.Error(UnknownName("filter", type, FilterTypes::kNames));
        return {};
    }
    params.ReportUnused();
    return filter;
}

}  // namespace pbrt
