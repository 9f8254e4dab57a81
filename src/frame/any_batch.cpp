// SPDX-License-Identifier: MIT
#include "hodograph/frame/any_batch.hpp"

#include <string>
#include <type_traits>

#include "hodograph/frame/batch.hpp"

namespace hodograph {

namespace {

/// Flat numbers as items that consist of such numbers alone.
template <class T>
std::span<T> as(std::span<double> numbers, std::size_t count, const char* name) {
  static_assert(sizeof(T) % sizeof(double) == 0 && alignof(T) == alignof(double));
  constexpr std::size_t one = sizeof(double), size = sizeof(T) / one;
  if (numbers.empty()) return {};
  batch_detail::require_size(numbers.size(), count * size, true, name);
  return {reinterpret_cast<T*>(numbers.data()), count};
}

template <class A>
void write_jets(const AnyPath& path, std::span<const double> xi,
                std::span<PreimageJet<A, 4>> jets) {
  batch_detail::require_size(jets.size(), xi.size(), false, "jets");
  batch_detail::require_inside(xi, path.xi_begin(), path.xi_end(), "path parameter xi");
  path.visit([&]<class P>(const P& p) {
    if constexpr (std::is_same_v<typename P::Algebra, A>) {
      for (std::size_t i = 0; i < xi.size(); ++i) jets[i] = p.template preimage_jet<4>(xi[i]);
    } else {
      throw Error(Fault{FaultCode::unsupported,
                        "the path has " + std::to_string(path.dimension()) +
                            " dimensions; a path of " + std::to_string(point_t<A>::dimension) +
                            " is needed here",
                        std::nullopt, "dimension", static_cast<double>(path.dimension()),
                        static_cast<double>(point_t<A>::dimension)});
    }
  });
}

}  // namespace

void evaluate(const AnyPath& path, std::span<const double> xi, const AnyPathStateSpans& out) {
  path.visit([&]<class P>(const P& p) {
    using A = typename P::Algebra;
    const std::size_t count = xi.size();
    evaluate(p, xi,
             PathStateSpans<A>{as<point_t<A>>(out.positions, count, "positions"),
                               as<frame_t<A>>(out.frames, count, "frames"),
                               as<rate_t<A>>(out.body_rates_per_xi, count, "body rates"),
                               out.speeds, out.arc_lengths});
  });
}

void preimage_jets(const AnyPath& path, std::span<const double> xi,
                   std::span<PreimageJet<Complex<double>, 4>> jets) {
  write_jets<Complex<double>>(path, xi, jets);
}
void preimage_jets(const AnyPath& path, std::span<const double> xi,
                   std::span<PreimageJet<Quaternion<double>, 4>> jets) {
  write_jets<Quaternion<double>>(path, xi, jets);
}

void parameters_at_arc_lengths(const AnyPath& path, std::span<const double> s,
                               std::span<double> xi) {
  path.visit([&](const auto& p) { parameters_at_arc_lengths(p, s, xi); });
}

void points_at_arc_lengths(const AnyPath& path, std::span<const double> s,
                           std::span<double> points) {
  path.visit([&]<class P>(const P& p) {
    points_at_arc_lengths(p, s, as<typename P::Point>(points, s.size(), "points"));
  });
}

}  // namespace hodograph
