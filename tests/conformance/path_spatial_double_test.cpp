// SPDX-License-Identifier: MIT
#include "tests/conformance/path_suite.hpp"

namespace hodograph::test {

// Between them the planar and the spatial file take every degree from 0 to 8.
using SpatialDoublePaths = testing::Types<SpatialPath<0>, SpatialPath<1>, SpatialPath<2>,
                                          SpatialPath<4>, SpatialPath<6>, SpatialPath<8>>;
INSTANTIATE_TYPED_TEST_SUITE_P(SpatialDouble, PathConformance, SpatialDoublePaths);

}  // namespace hodograph::test
