#include "pbrt/plot/axis.h"

#include <gtest/gtest.h>

namespace pbrt::plot {
namespace {

TEST(Axis, TicksAreRoundNumbers) {
    EXPECT_EQ((Axis{0, 0.34, 100, 0}.Ticks(6)), (std::vector<double>{0, 0.1, 0.2, 0.1 * 3}));
    EXPECT_EQ((Axis{360, 830, 0, 1}.Ticks(9)).front(), 400);
    EXPECT_EQ((Axis{-1, 1, 0, 1}.Ticks(4)), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    EXPECT_EQ((Axis{-1, 1, 10, 20}.At(0)), 15);
}

}  // namespace
}  // namespace pbrt::plot
