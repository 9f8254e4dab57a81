// SPDX-License-Identifier: MIT
// The Hermite constructions compiled once for the built-in scalars.
#include "hodograph/construction/hermite.hpp"

namespace hodograph {

#define HODOGRAPH_INSTANTIATE(m, S)                                                   \
  template Result<SpatialPhCurve<2 * m, S>> hermite_curve<m, S>(                      \
      const HermitePoint<m, S>&, const HermitePoint<m, S>&, const S&, HermiteChoice); \
  template Result<SpatialPhCurve<2 * m, S>> hermite_curve<m, S>(                      \
      const HermitePoint<m, S>&, const HermitePoint<m, S>&, const S&,                 \
      const HermiteParameters<m, S>&);                                                \
  template Result<SpatialPath<2 * m, S>> hermite_path<m, S>(                          \
      std::vector<S>, std::span<const HermitePoint<m, S>>, HermiteChoice, bool);

HODOGRAPH_INSTANTIATE(1, double)
HODOGRAPH_INSTANTIATE(2, double)
HODOGRAPH_INSTANTIATE(4, double)
HODOGRAPH_INSTANTIATE(1, long double)
HODOGRAPH_INSTANTIATE(2, long double)
HODOGRAPH_INSTANTIATE(4, long double)

#undef HODOGRAPH_INSTANTIATE

}  // namespace hodograph
