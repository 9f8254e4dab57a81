// SPDX-License-Identifier: MIT
// A path whose dimension and degree are known only when the program runs: what files, requests and
// bindings hold. Everything else works on the Path inside, through visit.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "hodograph/path/path.hpp"

namespace hodograph {

/// The largest preimage degree an AnyPath holds (path degree 25); higher ones are refused.
inline constexpr std::size_t maximum_dynamic_degree = 12;

/// The numbers that define a path, flat, as they stand in files. Segment k owns entries
/// [k d, (k + 1) d) of `starts`, d = dimension, and [k c, (k + 1) c) of `preimages`,
/// c = (preimage_degree + 1) · components_per_coefficient(): its Bernstein coefficients one after
/// the other, each (re, im) in the plane and (w, x, y, z) in space, in the global scaling.
struct PathNumbers {
  std::size_t dimension = 3;  ///< 2 or 3
  std::size_t preimage_degree = 0;
  bool closed = false;
  std::vector<double> knots, starts, preimages;

  std::size_t components_per_coefficient() const { return dimension == 2 ? 2 : 4; }
  friend bool operator==(const PathNumbers&, const PathNumbers&) = default;
};

namespace any_path_detail {

template <class Degrees>
struct Alternatives;
template <std::size_t... n>
struct Alternatives<std::index_sequence<n...>> {
  using type = std::variant<PlanarPath<n>..., SpatialPath<n>...>;
};

template <class P>
inline constexpr bool is_held = false;
template <std::size_t n>
inline constexpr bool is_held<PlanarPath<n>> = n <= maximum_dynamic_degree;
template <std::size_t n>
inline constexpr bool is_held<SpatialPath<n>> = n <= maximum_dynamic_degree;

}  // namespace any_path_detail

/// A planar or spatial path of preimage degree 0 ... maximum_dynamic_degree, in double. A value:
/// copies are independent. Queries by ξ have the domain and errors of Path.
class AnyPath {
 public:
  using Alternatives =
      any_path_detail::Alternatives<std::make_index_sequence<maximum_dynamic_degree + 1>>::type;

  /// The holder of a path of static type; implicit, since nothing is lost.
  template <class P>
    requires any_path_detail::is_held<P>
  AnyPath(P path);

  // Compiled once, in the library: 26 kinds take long to copy, move and destroy in every file.
  AnyPath(const AnyPath& other);
  AnyPath(AnyPath&& other) noexcept;
  AnyPath& operator=(const AnyPath& other);
  AnyPath& operator=(AnyPath&& other) noexcept;
  ~AnyPath();

  /// The path that the numbers define.
  /// Faults: unsupported (a dimension other than 2 and 3, a degree above maximum_dynamic_degree),
  /// too_few (fewer than 2 knots), mismatched_size (knots, starts and preimages disagree), and
  /// those of Path::create.
  static Result<AnyPath> create(const PathNumbers& numbers);
  /// The numbers that define this path; create(numbers()) returns an equal path, bit for bit.
  PathNumbers numbers() const;

  /// visitor(path) with the path in its static type, as std::visit.
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), path_);
  }
  /// The path if it has this static type, else null.
  template <class P>
  const P* get_if() const {
    return std::get_if<P>(&path_);
  }

  /// 2 or 3.
  std::size_t dimension() const;
  std::size_t preimage_degree() const;
  /// The degree of the path, 2 · preimage_degree() + 1.
  std::size_t degree() const { return 2 * preimage_degree() + 1; }
  /// 2 (complex) or 4 (quaternion) numbers a coefficient.
  std::size_t preimage_components() const { return dimension() == 2 ? 2 : 4; }
  std::size_t segment_count() const { return knots().size() - 1; }
  bool is_closed() const;
  const std::vector<double>& knots() const;
  const std::vector<double>& knot_arc_lengths() const;
  double arc_length() const { return knot_arc_lengths().back(); }
  double xi_begin() const { return knots().front(); }
  double xi_end() const { return knots().back(); }

  /// r(ξ) into dimension() numbers, A(ξ) into preimage_components() numbers (contract: the sizes
  /// fit).
  void position(double xi, std::span<double> result) const;
  void preimage(double xi, std::span<double> result) const;
  /// σ(ξ) and s(ξ).
  double speed(double xi) const;
  double arc_length(double xi) const;

  /// Bytes held.
  std::size_t memory() const;

  friend bool operator==(const AnyPath& a, const AnyPath& b);

 private:
  Alternatives path_;
};

}  // namespace hodograph
