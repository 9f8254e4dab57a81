// SPDX-License-Identifier: MIT
// What the preimage's derivatives yield at many parameters: derivatives, tangents, curvature,
// torsion, frames and their rates.
#include <algorithm>
#include <array>
#include <string>

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/any_batch.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

template <class A>
using Jet = PreimageJet<A, 4>;

constexpr std::size_t block = 256;  ///< jets of one block stay in the cache

/// each(jet, index) for every parameter, in order.
template <class A, class Each>
void for_jets(const AnyPath& path, std::span<const double> xi, const Each& each) {
  std::array<Jet<A>, block> jets;
  for (std::size_t first = 0; first < xi.size(); first += block) {
    const std::size_t count = std::min(block, xi.size() - first);
    try {
      preimage_jets(path, xi.subspan(first, count), std::span<Jet<A>>(jets.data(), count));
    } catch (const Error& error) {  // its index counts from the block
      Fault fault = error.fault();
      if (fault.index) *fault.index += first;
      throw Error(fault);
    }
    for (std::size_t i = 0; i < count; ++i) each(jets[i], first + i);
  }
}

/// The jets of either algebra.
template <class Each>
void for_any_jets(const AnyPath& path, std::span<const double> xi, const Each& each) {
  if (path.dimension() == 2) {
    for_jets<Complex<double>>(path, xi, each);
  } else {
    for_jets<Quaternion<double>>(path, xi, each);
  }
}

template <class A>
void require_motion(const Jet<A>& jet, double xi, std::size_t index, const char* what) {
  if (0.0 < speed_form(jet[0], jet[0])) return;
  throw Error(Fault{FaultCode::zero_speed,
                    "the path stands still at xi = " + to_text(xi) + " (index " +
                        std::to_string(index) + "): no " + what + " exists there",
                    index, "speed", 0.0, std::nullopt});
}

void write(std::span<double> to, std::size_t index, double value) { to[index] = value; }
template <class V>
  requires requires { V::dimension; }
void write(std::span<double> to, std::size_t index, const V& value) {
  for (std::size_t i = 0; i < V::dimension; ++i) to[index * V::dimension + i] = value[i];
}

py::ssize_t size(std::size_t n) { return static_cast<py::ssize_t>(n); }

Doubles derivatives(const AnyPath& path, const Doubles& xi, std::size_t order) {
  if (order > 4) {
    throw Error(Fault{FaultCode::unsupported,
                      "derivatives of order 0 to 4 are offered; got " + std::to_string(order),
                      std::nullopt, "order", static_cast<double>(order), 4.0});
  }
  return filled_like(xi, {size(path.dimension())}, [&](auto from, auto to) {
    if (order == 0) return evaluate(path, from, {.positions = to});
    for_any_jets(path, from, [&](const auto& jet, std::size_t i) {
      write(to, i, hodograph_derivatives(jet)[order - 1]);
    });
  });
}

Doubles preimage(const AnyPath& path, const Doubles& xi, std::size_t order) {
  if (order > 4) {
    throw Error(Fault{FaultCode::unsupported,
                      "derivatives of order 0 to 4 are offered; got " + std::to_string(order),
                      std::nullopt, "order", static_cast<double>(order), 4.0});
  }
  return filled_like(xi, {size(path.preimage_components())}, [&](auto from, auto to) {
    for_any_jets(path, from, [&](const auto& jet, std::size_t i) { write(to, i, jet[order]); });
  });
}

Doubles tangents(const AnyPath& path, const Doubles& xi) {
  return filled_like(xi, {size(path.dimension())}, [&](auto from, auto to) {
    for_any_jets(path, from, [&](const auto& jet, std::size_t i) {
      require_motion(jet, from[i], i, "tangent");
      write(to, i, tangent(jet));
    });
  });
}

FloatOrArray curvatures(const AnyPath& path, const Doubles& xi) {
  return numbers_like(xi, [&](auto from, auto to) {
    for_any_jets(path, from, [&](const auto& jet, std::size_t i) {
      require_motion(jet, from[i], i, "curvature");
      to[i] = curvature(jet);
    });
  });
}

FloatOrArray torsions(const AnyPath& path, const Doubles& xi) {
  return numbers_like(xi, [&](auto from, auto to) {
    for_jets<Quaternion<double>>(path, from, [&](const auto& jet, std::size_t i) {
      require_motion(jet, from[i], i, "torsion");
      const auto tau = torsion(jet);
      if (!tau) {
        throw Error(Fault{FaultCode::outside_domain,
                          "the curvature is zero at xi = " + to_text(from[i]) + " (index " +
                              std::to_string(i) + "): no torsion exists there",
                          i, "curvature", 0.0, std::nullopt});
      }
      to[i] = *tau;
    });
  });
}

Strided frames(const AnyPath& path, const Doubles& xi) {
  const auto d = size(path.dimension());
  const Doubles axes =
      filled_like(xi, {d, d}, [&](auto from, auto to) { evaluate(path, from, {.frames = to}); });
  return axes.attr("swapaxes")(-1, -2);
}

/// rate(jet)[0] at every parameter: one number in the plane, a vector in space.
template <class Rate>
ArrayOrFloat rates(const AnyPath& path, const Doubles& xi, const Rate& rate) {
  const auto fill = [&](auto from, auto to) {
    for_any_jets(path, from, [&](const auto& jet, std::size_t i) {
      require_motion(jet, from[i], i, "frame");
      const std::array first{jet[0], jet[1]};
      write(to, i, rate(first)[0]);
    });
  };
  return filled_like(xi, path.dimension() == 2 ? Shape{} : Shape{3}, fill);
}

}  // namespace

void bind_frame(py::module_& m) {
  m.def("derivatives", &derivatives, py::arg("path"), py::arg("xi"), py::arg("order"),
        "The derivative of r of that order (0 to 4) with respect to xi, shape (..., d).");
  m.def("preimage", &preimage, py::arg("path"), py::arg("xi"), py::arg("order") = 0,
        "The preimage, or its derivative of that order (0 to 4), shape (..., 2 or 4).");
  m.def("tangent", &tangents, py::arg("path"), py::arg("xi"), "The unit tangent, shape (..., d).");
  m.def("curvature", &curvatures, py::arg("path"), py::arg("xi"),
        "The curvature: signed, positive to the left, in the plane; at least 0 in space.");
  m.def("torsion", &torsions, py::arg("path"), py::arg("xi"),
        "The torsion of a spatial path, where its curvature is not zero.");
  m.def("euler_rodrigues_frame", &frames, py::arg("path"), py::arg("xi"),
        "The frame that the preimage carries, as matrices with the axes e1 (the tangent), e2, e3 "
        "as\ncolumns, shape (..., d, d).");
  m.def(
      "body_rate_per_xi",
      [](const AnyPath& path, const Doubles& xi) {
        return rates(path, xi, [](const auto& jet) { return body_rate_per_xi(jet); });
      },
      py::arg("path"), py::arg("xi"),
      "The angular velocity of the Euler-Rodrigues frame per unit xi in body components: R' = R "
      "[chi]x.");
  m.def(
      "body_rate_per_arc_length",
      [](const AnyPath& path, const Doubles& xi) {
        return rates(path, xi, [](const auto& jet) { return body_rate_per_arc_length(jet); });
      },
      py::arg("path"), py::arg("xi"), "The same per unit of arc length.");
  m.def(
      "world_rate_per_xi",
      [](const AnyPath& path, const Doubles& xi) {
        return rates(path, xi, [](const auto& jet) { return world_rate_per_xi(jet); });
      },
      py::arg("path"), py::arg("xi"), "The angular velocity per unit xi as a world vector.");
  m.def(
      "world_rate_per_arc_length",
      [](const AnyPath& path, const Doubles& xi) {
        return rates(path, xi, [](const auto& jet) { return world_rate_per_arc_length(jet); });
      },
      py::arg("path"), py::arg("xi"), "The same per unit of arc length.");
}

}  // namespace hodograph::python
