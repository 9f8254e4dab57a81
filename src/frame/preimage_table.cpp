// SPDX-License-Identifier: MIT
#include "hodograph/frame/preimage_table.hpp"

#include <utility>

namespace hodograph {

PreimageTable::PreimageTable(const PreimageRows& rows)
    : degree(rows.degree), closed(rows.closed), knots(rows.knots.begin(), rows.knots.end()) {
  coefficients.reserve((knots.size() - 1) * (degree + 1));
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const Quaternion<double>* first = rows.row(rows.path, k);
    coefficients.insert(coefficients.end(), first, first + degree + 1);
  }
}

Result<PreimageTable> PreimageTable::of(const AnyPath& path) {
  if (path.dimension() != 3) {
    return Fault{FaultCode::unsupported,
                 "the path is in the plane, where the frame is tangent and normal; rolls are for "
                 "paths in space",
                 std::nullopt,
                 "dimension",
                 static_cast<double>(path.dimension()),
                 3.0};
  }
  PathNumbers numbers = path.numbers();
  PreimageTable table;
  table.degree = numbers.preimage_degree;
  table.closed = numbers.closed;
  table.knots = std::move(numbers.knots);
  const auto& flat = numbers.preimages;
  table.coefficients.reserve(flat.size() / 4);
  for (std::size_t i = 0; i + 3 < flat.size(); i += 4) {
    table.coefficients.push_back({flat[i], flat[i + 1], flat[i + 2], flat[i + 3]});
  }
  return table;
}

}  // namespace hodograph
