#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace pbrt {

/// A closed set of types: the one place where a plug-in is listed. Every type has `kName`.
template <typename... Ts>
struct TypeList {
    using Variant = std::variant<Ts...>;
    static constexpr std::array<std::string_view, sizeof...(Ts)> kNames{Ts::kName...};

    /// Calls visit.template operator()<T>() for the type whose name is `name`; false where none is.
    template <typename F>
    static bool Visit(std::string_view name, F &&visit) {
        return ((name == Ts::kName && (visit.template operator()<Ts>(), true)) || ...);
    }
};

}  // namespace pbrt
