// SPDX-License-Identifier: MIT
// A path as a solver needs it: position, frame, angular velocity and speed with two exact
// derivatives at any ξ, whatever the degree, in well under a microsecond.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/foundation/second_order.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// What a place on a path is named by.
enum class ProgressBy {
  xi,         ///< the path's parameter
  arc_length  ///< s: σ = 1, and only what the geometry has of corners and jumps remains
};

/// r, R, χ and σ at one ξ, each with its first and second derivative by ξ; by arc length, s takes
/// the place of ξ throughout. Its numbers fill whole cache lines.
template <class A>
struct alignas(64) ReferenceJet {
  std::array<point_t<A>, 3> position{};
  std::array<frame_t<A>, 3> frame{};
  std::array<rate_t<A>, 3> body_rate{};
  std::array<typename A::Scalar, 3> speed{};
};

/// The same as values of any scalar, from a ξ of that scalar.
template <class A, class S>
struct ReferenceValue;
template <class S>
struct ReferenceValue<Complex<double>, S> {
  Vector2<S> position{};
  Frame2<S> frame{};
  S body_rate{}, speed{};
};
template <class S>
struct ReferenceValue<Quaternion<double>, S> {
  Vector3<S> position{};
  Frame3<S> frame{};
  Vector3<S> body_rate{};
  S speed{};
};

/// The curve of a path in the plane (A = Complex<double>) or in space (Quaternion<double>).
///
/// Beyond the knots the first and the last polynomial go on, so that the stages of an integrator
/// may reach over the end; a closed path whose frame closes goes round (the later start of ξ is one
/// period on). Where the speed vanishes, frame and rate are not finite.
///
/// Method: each segment as powers of x = 2u - 1, whose coefficients are those of Bernstein form up
/// to rounding; the frame and the rates from A, A', A'', A''' by the formulas of frame/. Accuracy
/// on the knots: 2n + 2 roundings of the sum of the coefficients' sizes. By arc length, ξ is found
/// by Newton's method on the polynomial s(ξ).
template <class A>
class ReferencePath {
 public:
  /// Faults: unsupported (a path of the other dimension).
  static Result<ReferencePath> of(const AnyPath& path, ProgressBy progress = ProgressBy::xi);

  ProgressBy progress_by() const { return progress_by_; }
  /// The progress at the first and the last knot.
  double begin() const { return begins_.front(); }
  double end() const { return begins_.back(); }
  /// Whether the progress goes round.
  bool is_periodic() const { return periodic_; }
  /// ξ of a progress, and the progress of a ξ; round a periodic path, whole periods on.
  double xi_of(double progress) const;
  double progress_of(double xi) const;

  ReferenceJet<A> at(double progress) const;
  /// The same, bit for bit, at many places at once, several in each wide register of the processor:
  /// a fraction of the time. Fastest where the places ascend. The spans have one size (contract).
  void at(std::span<const double> progress, std::span<ReferenceJet<A>> result) const;
  /// Without derivatives.
  ReferenceValue<A, double> value(double progress) const;

  /// At a progress that carries derivatives, by the chain rule.
  template <class S>
  ReferenceValue<A, S> on(const S& progress) const {
    if constexpr (std::is_same_v<S, double>) {
      return value(progress);
    } else {
      return composed(at(progress.value()), progress);
    }
  }

 private:
  struct Place {
    std::size_t segment;
    double x, inverse;  ///< in [-1, 1] between the knots; dx/dξ
  };
  Place locate(double progress, std::size_t near = 0) const;
  double periods(double progress, const std::vector<double>& marks) const;
  double length_at(std::size_t segment, double x, double* slope) const;
  template <std::size_t K>
  PreimageJet<A, K> preimage_jet(const Place& at) const;
  point_t<A> position(const Place& at) const;

  template <class S>
  static ReferenceValue<A, S> composed(const ReferenceJet<A>& jet, const S& xi);

  std::size_t degree_ = 0;
  bool periodic_ = false;
  ProgressBy progress_by_ = ProgressBy::xi;
  std::vector<double> knots_, begins_;  // ξ and the progress at every knot
  std::vector<double> inverses_;        // dx/dξ of every segment
  // Rows of four numbers, degree + 1 and 2 degree + 2 a segment: the preimage, and the position
  // with the arc length from the segment's start behind it.
  std::vector<double> preimages_, integrals_;
};

template <class A>
template <class S>
ReferenceValue<A, S> ReferencePath<A>::composed(const ReferenceJet<A>& jet, const S& xi) {
  ReferenceValue<A, S> result;
  const auto number = [&xi](double f, double df, double ddf) { return xi.through(f, df, ddf); };
  const auto vector = [&](const auto& v, auto& to) {
    for (std::size_t i = 0; i < std::remove_cvref_t<decltype(to)>::dimension; ++i) {
      to[i] = number(v(0)[i], v(1)[i], v(2)[i]);
    }
  };
  vector([&](std::size_t r) { return jet.position[r]; }, result.position);
  vector([&](std::size_t r) { return jet.frame[r].e1; }, result.frame.e1);
  vector([&](std::size_t r) { return jet.frame[r].e2; }, result.frame.e2);
  if constexpr (A::dimension == 4) {
    vector([&](std::size_t r) { return jet.frame[r].e3; }, result.frame.e3);
    vector([&](std::size_t r) { return jet.body_rate[r]; }, result.body_rate);
  } else {
    result.body_rate = number(jet.body_rate[0], jet.body_rate[1], jet.body_rate[2]);
  }
  result.speed = number(jet.speed[0], jet.speed[1], jet.speed[2]);
  return result;
}

extern template class ReferencePath<Complex<double>>;
extern template class ReferencePath<Quaternion<double>>;

/// How far a path may be left to its sides such that its coordinates are regular: the largest
/// offsets with h > 0 at every ξ, certified (each is below the true one by rounding and the width
/// of the curvature's enclosure alone). h = σ (1 - κ η) in the plane, h ≥ σ (1 - κ |η|) in space.
struct OffsetLimits {
  double left = 0.0;   ///< to the positive side; in space to any. Infinite where no bend limits it
  double right = 0.0;  ///< to the other
  Enclosure curvature_minimum, curvature_maximum;  ///< signed in the plane
};

/// Cost: that of curvature_extremes. Zero where the speed may vanish.
OffsetLimits offset_limits(const AnyPath& path);

}  // namespace hodograph
