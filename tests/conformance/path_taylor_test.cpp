// SPDX-License-Identifier: MIT
#include "tests/conformance/path_suite.hpp"

namespace hodograph::test {

using Series = Taylor<double, 2>;
using TaylorPaths = testing::Types<PlanarPath<1, Series>, PlanarPath<4, Series>,
                                   SpatialPath<2, Series>, SpatialPath<8, Series>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Taylor, PathConformance, TaylorPaths);

}  // namespace hodograph::test
