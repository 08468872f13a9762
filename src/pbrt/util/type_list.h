#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <variant>

namespace pbrt {

/// A closed set of types: the one place where a plug-in is listed. Every type has `kName`.
template <typename... Ts>
struct TypeList {
    using Variant = std::variant<Ts...>;
    static constexpr size_t kSize = sizeof...(Ts);
    /// The list with more types behind.
    template <typename... Us>
    using Append = TypeList<Ts..., Us...>;
    /// The place of T, as Variant's index() gives it.
    template <typename T>
    static constexpr size_t kIndexOf = [] {
        size_t i = 0;
        (void)((std::is_same_v<T, Ts> || (++i, false)) || ...);
        return i;
    }();
    static constexpr std::array<std::string_view, sizeof...(Ts)> kNames{Ts::kName...};

    /// Calls visit.template operator()<T>() for the type whose name is `name`; false where none is.
    template <typename F>
    static bool Visit(std::string_view name, F &&visit) {
        return ((name == Ts::kName && (visit.template operator()<Ts>(), true)) || ...);
    }
    /// Calls visit.template operator()<T>() for every type, in order.
    template <typename F>
    static constexpr void ForEach(F &&visit) {
        (visit.template operator()<Ts>(), ...);
    }
    /// Whether test.template operator()<T>() holds for every type: for contracts.
    template <typename F>
    static constexpr bool All(F &&test) {
        return (test.template operator()<Ts>() && ...);
    }
};

namespace detail {
template <size_t i, typename V, typename F>
[[gnu::always_inline]] inline decltype(auto) DispatchFrom(V &variant, F &f) {
    if constexpr (i + 1 == std::variant_size_v<std::remove_const_t<V>>)
        return f(*std::get_if<i>(&variant));
    else
        return variant.index() == i ? f(*std::get_if<i>(&variant))
                                    : DispatchFrom<i + 1>(variant, f);
}
}  // namespace detail

/// f(what the variant holds): the one way to call a member of a family's types. As std::visit, but
/// inlined where it is called; all f must return the same type. Also for classes that derive from a
/// variant.
template <typename... Ts, typename F>
[[gnu::always_inline]] inline decltype(auto) Dispatch(std::variant<Ts...> &variant, F &&f) {
    return detail::DispatchFrom<0>(variant, f);
}
template <typename... Ts, typename F>
[[gnu::always_inline]] inline decltype(auto) Dispatch(const std::variant<Ts...> &variant, F &&f) {
    return detail::DispatchFrom<0>(variant, f);
}

}  // namespace pbrt
