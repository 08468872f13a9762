#pragma once

#include <gtest/gtest.h>

#include "pbrt/util/type_list.h"

namespace pbrt::test {

namespace detail {
template <typename List>
struct ToTestTypes;
template <typename... Ts>
struct ToTestTypes<TypeList<Ts...>> {
    using Types = testing::Types<Ts...>;
};
}  // namespace detail

/// A family's list for TYPED_TEST_SUITE, so that each law is tested on each of its types.
template <typename List>
using TestTypesOf = typename detail::ToTestTypes<List>::Types;

}  // namespace pbrt::test
