// SPDX-License-Identifier: MIT
#include "hodograph/path/any_path.hpp"

#include <array>
#include <string>

namespace hodograph {

namespace {

template <class V>
V read(const double* from) {
  V value{};
  for (std::size_t i = 0; i < V::dimension; ++i) value[i] = from[i];
  return value;
}

template <class V>
void append(std::vector<double>& to, const V& value) {
  for (std::size_t i = 0; i < V::dimension; ++i) to.push_back(value[i]);
}

template <class V>
void write(std::span<double> to, const V& value) {
  for (std::size_t i = 0; i < V::dimension; ++i) to[i] = value[i];
}

template <class P>
Result<AnyPath> path_of(const PathNumbers& numbers) {
  using Curve = typename P::Curve;
  using A = typename P::Algebra;
  using Point = typename P::Point;
  constexpr std::size_t n = P::preimage_degree;
  std::vector<Curve> segments;
  const std::size_t count = numbers.knots.size() - 1;
  segments.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<A, n + 1> coefficients;
    for (std::size_t i = 0; i <= n; ++i) {
      coefficients[i] = read<A>(&numbers.preimages[(k * (n + 1) + i) * A::dimension]);
    }
    segments.emplace_back(read<Point>(&numbers.starts[k * Point::dimension]),
                          typename Curve::Preimage(coefficients),
                          numbers.knots[k + 1] - numbers.knots[k]);
  }
  auto path = P::create(numbers.knots, std::move(segments), numbers.closed);
  if (!path) return path.fault();
  return AnyPath(*std::move(path));
}

using Reader = Result<AnyPath> (*)(const PathNumbers&);

template <template <std::size_t> class P, std::size_t... n>
constexpr std::array<Reader, sizeof...(n)> readers(std::index_sequence<n...>) {
  return {path_of<P<n>>...};
}
template <std::size_t n>
using Planar = PlanarPath<n>;
template <std::size_t n>
using Spatial = SpatialPath<n>;

Fault wrong_count(const char* quantity, std::size_t expected, std::size_t got,
                  const std::string& why) {
  return {
      FaultCode::mismatched_size,
      why + " need " + std::to_string(expected) + " " + quantity + "; got " + std::to_string(got),
      std::nullopt,
      quantity,
      static_cast<double>(got),
      static_cast<double>(expected)};
}

}  // namespace

template <class P>
  requires any_path_detail::is_held<P>
AnyPath::AnyPath(P path) : path_(std::move(path)) {}

#define HODOGRAPH_HELD(prefix, n)                  \
  prefix template AnyPath::AnyPath(PlanarPath<n>); \
  prefix template AnyPath::AnyPath(SpatialPath<n>);
HODOGRAPH_FOR_COMPILED_DEGREES(HODOGRAPH_HELD, )

AnyPath::AnyPath(const AnyPath& other) = default;
AnyPath::AnyPath(AnyPath&& other) noexcept = default;
AnyPath& AnyPath::operator=(const AnyPath& other) = default;
AnyPath& AnyPath::operator=(AnyPath&& other) noexcept = default;
AnyPath::~AnyPath() = default;

bool operator==(const AnyPath& a, const AnyPath& b) { return a.path_ == b.path_; }

Result<AnyPath> AnyPath::create(const PathNumbers& numbers) {
  if (numbers.dimension != 2 && numbers.dimension != 3) {
    return Fault{FaultCode::unsupported,
                 "the dimension of a path is 2 or 3; got " + std::to_string(numbers.dimension),
                 std::nullopt,
                 "dimension",
                 static_cast<double>(numbers.dimension),
                 std::nullopt};
  }
  if (numbers.preimage_degree > maximum_dynamic_degree) {
    return Fault{FaultCode::unsupported,
                 "the preimage degree is at most " + std::to_string(maximum_dynamic_degree) +
                     "; got " + std::to_string(numbers.preimage_degree),
                 std::nullopt,
                 "preimage_degree",
                 static_cast<double>(numbers.preimage_degree),
                 static_cast<double>(maximum_dynamic_degree)};
  }
  if (numbers.knots.size() < 2) {
    return Fault{FaultCode::too_few,
                 "a path needs at least two knots; got " + std::to_string(numbers.knots.size()),
                 std::nullopt,
                 "knots",
                 static_cast<double>(numbers.knots.size()),
                 2.0};
  }
  const std::size_t count = numbers.knots.size() - 1;
  const std::string segments = std::to_string(count) + (count == 1 ? " segment" : " segments") +
                               " of preimage degree " + std::to_string(numbers.preimage_degree) +
                               " in dimension " + std::to_string(numbers.dimension);
  if (numbers.starts.size() != count * numbers.dimension) {
    return wrong_count("starts", count * numbers.dimension, numbers.starts.size(), segments);
  }
  const std::size_t per_segment =
      (numbers.preimage_degree + 1) * numbers.components_per_coefficient();
  if (numbers.preimages.size() != count * per_segment) {
    return wrong_count("preimages", count * per_segment, numbers.preimages.size(), segments);
  }
  using Degrees = std::make_index_sequence<maximum_dynamic_degree + 1>;
  static constexpr auto planar = readers<Planar>(Degrees{});
  static constexpr auto spatial = readers<Spatial>(Degrees{});
  return (numbers.dimension == 2 ? planar : spatial)[numbers.preimage_degree](numbers);
}

PathNumbers AnyPath::numbers() const {
  return visit([]<class P>(const P& path) {
    PathNumbers numbers;
    numbers.dimension = P::Point::dimension;
    numbers.preimage_degree = P::preimage_degree;
    numbers.closed = path.is_closed();
    numbers.knots = path.knots();
    numbers.starts.reserve(path.segment_count() * P::Point::dimension);
    numbers.preimages.reserve(path.segment_count() * (P::preimage_degree + 1) *
                              P::Algebra::dimension);
    for (const auto& curve : path.segments()) {
      append(numbers.starts, curve.start());
      for (const auto& a : curve.preimage().coefficients()) append(numbers.preimages, a);
    }
    return numbers;
  });
}

std::size_t AnyPath::dimension() const { return path_.index() <= maximum_dynamic_degree ? 2 : 3; }

std::size_t AnyPath::preimage_degree() const {
  return path_.index() % (maximum_dynamic_degree + 1);
}

bool AnyPath::is_closed() const {
  return visit([](const auto& path) { return path.is_closed(); });
}

const std::vector<double>& AnyPath::knots() const {
  return visit([](const auto& path) -> const std::vector<double>& { return path.knots(); });
}

const std::vector<double>& AnyPath::knot_arc_lengths() const {
  return visit(
      [](const auto& path) -> const std::vector<double>& { return path.knot_arc_lengths(); });
}

void AnyPath::position(double xi, std::span<double> result) const {
  visit([&](const auto& path) { write(result, path.position(xi)); });
}

void AnyPath::preimage(double xi, std::span<double> result) const {
  visit([&](const auto& path) { write(result, path.preimage(xi)); });
}

double AnyPath::speed(double xi) const {
  return visit([&](const auto& path) { return path.speed(xi); });
}

double AnyPath::arc_length(double xi) const {
  return visit([&](const auto& path) { return path.arc_length(xi); });
}

std::size_t AnyPath::memory() const {
  return visit([](const auto& path) { return path.memory(); });
}

}  // namespace hodograph
