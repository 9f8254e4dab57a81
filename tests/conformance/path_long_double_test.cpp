// SPDX-License-Identifier: MIT
#include "tests/conformance/path_suite.hpp"

namespace hodograph::test {

using LongDoublePaths = testing::Types<PlanarPath<2, long double>, PlanarPath<5, long double>,
                                       SpatialPath<0, long double>, SpatialPath<4, long double>,
                                       SpatialPath<8, long double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(LongDouble, PathConformance, LongDoublePaths);

}  // namespace hodograph::test
