#pragma once

#include <concepts>
#include <span>
#include <string_view>

namespace pbrt {

/// Members of every type of every family:
///   kName      what the scene language calls it; different within a family
///   kExamples  parameter lists as they follow the name in a scene file, for example
///              "\"float eta\" 1.3"; typical ones and such at the ends of their ranges, "" for all
///              defaults. Each must be read without a message. The family's tests build each of
///              them and hold it against the laws of the family, so a new type has its tests with
///              these
template <typename T>
concept PlugInType = requires {
    { T::kName } -> std::convertible_to<std::string_view>;
    { T::kExamples } -> std::convertible_to<std::span<const std::string_view>>;
}
&&(std::span<const std::string_view>(T::kExamples).size() > 0);

namespace detail {
/// An optional member is there exactly where the type's traits announce it.
template <bool announced, bool there>
concept AsAnnounced = announced == there;
}  // namespace detail

}  // namespace pbrt
