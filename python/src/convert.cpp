// SPDX-License-Identifier: MIT
#include "python/src/convert.hpp"

namespace hodograph::python {

void refuse_shape(const std::string& name, const std::string& wanted, const Doubles& got) {
  std::string shape = "(";
  for (py::ssize_t i = 0; i < got.ndim(); ++i) {
    shape += (i > 0 ? ", " : "") + std::to_string(got.shape(i));
  }
  shape += got.ndim() == 1 ? ",)" : ")";
  throw Error(Fault{FaultCode::mismatched_size,
                    name + " should have the shape " + wanted + "; got " + shape, std::nullopt,
                    name, std::nullopt, std::nullopt});
}

Doubles view_of(const double* data, const Shape& shape, py::handle owner) {
  Doubles view(shape, data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

}  // namespace hodograph::python
