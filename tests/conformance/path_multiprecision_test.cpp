// SPDX-License-Identifier: MIT
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tests/conformance/path_suite.hpp"

namespace hodograph::test {

/// 50 decimal digits, without expression templates: every operation returns a number.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;
using WidePaths = testing::Types<PlanarPath<2, Wide>, SpatialPath<4, Wide>, SpatialPath<8, Wide>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Multiprecision, PathConformance, WidePaths);

}  // namespace hodograph::test
