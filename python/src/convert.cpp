// SPDX-License-Identifier: MIT
#include "python/src/convert.hpp"

#include <cmath>

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

bool SignalWatch::raised() {
  if (exception_) return true;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(20)) return false;
  last_ = now;
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) {
    try {
      throw py::error_already_set();
    } catch (...) {
      exception_ = std::current_exception();
    }
  }
  return exception_ != nullptr;
}

void SignalWatch::rethrow() const {
  if (exception_) std::rethrow_exception(exception_);
}

Doubles view_of(const double* data, const Shape& shape, py::handle owner) {
  Doubles view(shape, data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

std::vector<double> numbers_of(const Doubles& array, const std::string& name) {
  if (array.ndim() != 1) refuse_shape(name, "(n,)", array);
  const auto all = numbers(array);
  return {all.begin(), all.end()};
}

void require_finite(std::span<const double> values, const std::string& name) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw Error(Fault{
          FaultCode::not_finite,
          name + " should be finite; number " + std::to_string(i) + " is " + to_text(values[i]), i,
          name, values[i], std::nullopt});
    }
  }
}

Doubles array_of(const Frame3<double>& frame) {
  Doubles result(Shape{3, 3});
  double* to = result.mutable_data();
  for (std::size_t i = 0; i < 3; ++i) {
    for (const auto* axis : {&frame.e1, &frame.e2, &frame.e3}) *to++ = (*axis)[i];
  }
  return result;
}

void read_array(const Doubles& array, Frame3<double>& to) {
  if (array.ndim() != 2 || array.shape(0) != 3 || array.shape(1) != 3) {
    refuse_shape("a frame", "(3, 3)", array);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    to.e1[i] = array.data()[3 * i];
    to.e2[i] = array.data()[3 * i + 1];
    to.e3[i] = array.data()[3 * i + 2];
  }
}

}  // namespace hodograph::python
