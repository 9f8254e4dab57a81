// SPDX-License-Identifier: MIT
#include "tests/conformance/path_suite.hpp"

namespace hodograph::test {

// Between them the planar and the spatial file take every degree from 0 to 8.
using PlanarDoublePaths = testing::Types<PlanarPath<0>, PlanarPath<1>, PlanarPath<2>, PlanarPath<3>,
                                         PlanarPath<5>, PlanarPath<7>>;
INSTANTIATE_TYPED_TEST_SUITE_P(PlanarDouble, PathConformance, PlanarDoublePaths);

}  // namespace hodograph::test
