// SPDX-License-Identifier: MIT
#include "hodograph/surface/sweep_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "enclosed_polynomial.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "polygon_triangulation.hpp"
#include "sweep_ring.hpp"

namespace hodograph {
namespace {

using surface_detail::product_up;
using surface_detail::sum_up;
using Index = TriangleMesh::Index;

/// A part of a piece of the motion, with what bounds the second derivatives over it.
struct Strip {
  std::size_t piece = 0;
  double a = 0.0, b = 1.0;
  double along = 0.0;     // ≥ |S_vv|, all of the profile
  double turning = 0.0;   // ≥ |λ'| + λ|χ|, so that |S_vu| ≤ turning |p'|
  double scale = 0.0;     // ≥ λ
  double rounding = 0.0;  // ≥ the error of a vertex

  /// The bound of the deviation where the strip is cut into `parts`, for a profile with
  /// h_u |p'| ≤ first and h_u² |p''| ≤ second.
  double deviation(double parts, double first, double second) const {
    const double sum = sum_up(
        Enclosure::up(Enclosure::up(along / parts) / parts),
        sum_up(Enclosure::up(2.0 * product_up(turning, first) / parts), product_up(scale, second)));
    return sum_up(0.125 * sum, rounding);
  }
  /// The least number of parts within the tolerance: the positive root of a quadratic. Infinite
  /// where there is none.
  double parts(double tolerance, double first, double second) const {
    const double room = 8.0 * (tolerance - rounding) - scale * second;
    if (!(room > 0.0)) return std::numeric_limits<double>::infinity();
    const double mixed = turning * first;
    double count =
        std::max(1.0, std::ceil((mixed + std::sqrt(mixed * mixed + along * room)) / room));
    while (std::isfinite(count) && deviation(count, first, second) > tolerance) count += 1.0;
    return count;
  }
};

/// How many chords each interval of the profile gets, and what that bounds.
struct Division {
  std::vector<double> chords;
  double count = 0.0, first = 0.0, second = 0.0;
};

class Mesher {
 public:
  Mesher(const Sweep& sweep, const SweepMeshOptions& options) : sweep_(sweep), options_(options) {}

  Result<SweepMesh> run() {
    if (!(std::isfinite(options_.tolerance) && options_.tolerance > 0.0)) {
      return Fault{FaultCode::outside_domain,
                   "the tolerance is " + to_text(options_.tolerance) +
                       "; it must be a positive finite number",
                   std::nullopt,
                   "tolerance",
                   options_.tolerance,
                   0.0};
    }
    constexpr double coarsest = 1.0 / 16.0;
    const double largest_useful = coarsest * sweep_.motion.least_scale() * sweep_.profile.extent();
    tolerance_ = std::min(options_.tolerance, largest_useful);
    set_seams();
    if (auto fault = find_strips()) return *fault;
    if (auto fault = find_division()) return *fault;
    place_rings();
    sample_profile();
    fill();
    if (auto fault = add_caps()) return *fault;
    result_.rings = rings_.size();
    result_.columns = positions_.size();
    return std::move(result_);
  }

 private:
  // ---- along the motion

  /// Where pieces meet, the mesh has the vertices of the later one: what rounding parts them.
  void set_seams() {
    const auto& pieces = sweep_.motion.pieces();
    const std::size_t joints = sweep_.motion.is_closed() ? pieces.size() : pieces.size() - 1;
    for (std::size_t k = 0; k < joints; ++k) {
      const MotionState end = sweep_.motion.at(k, 1.0);
      const MotionState begin = sweep_.motion.at((k + 1) % pieces.size(), 0.0);
      const double turned = norm(end.frame.e1 - begin.frame.e1) +
                            norm(end.frame.e2 - begin.frame.e2) +
                            norm(end.frame.e3 - begin.frame.e3);
      seam_ = std::max(seam_, norm(end.position - begin.position) +
                                  sweep_.profile.reach() *
                                      (end.scale * turned + std::abs(end.scale - begin.scale)));
    }
  }

  Strip strip_of(std::size_t k, double a, double b) const {
    const MotionBounds bounds = sweep_.motion.bounds(k, a, b);
    Strip strip{k, a, b, 0.0, 0.0, 0.0, 0.0};
    const double reach = sweep_.profile.reach();
    if (!bounds.is_bounded()) {
      strip.along = std::numeric_limits<double>::infinity();
      return strip;
    }
    const double turned = sum_up(bounds.rate_change, product_up(bounds.rate, bounds.rate));
    strip.along =
        sum_up(bounds.acceleration,
               product_up(reach, sum_up(bounds.scale_change,
                                        sum_up(product_up(2.0 * bounds.scale_rate, bounds.rate),
                                               product_up(bounds.scale, turned)))));
    strip.turning = sum_up(bounds.scale_rate, product_up(bounds.scale, bounds.rate));
    strip.scale = bounds.scale;
    // Of R p (three products of numbers rounded before) and of the sum with c.
    strip.rounding = seam_ + bounds.rounding +
                     bounds.scale * reach * (bounds.frame_rounding + profile_rounding());
    return strip;
  }
  double profile_rounding() const {
    std::size_t degree = 2;
    for (const auto& piece : sweep_.profile.pieces()) degree = std::max(degree, piece.degree());
    return 8.0 * accuracy::evaluation_error<double>(degree);
  }

  std::optional<Fault> find_strips() {
    constexpr int deepest = 50, deepest_bounded = 12;
    constexpr double worthwhile = 0.92;
    struct Part {
      Strip strip;
      int depth;
    };
    for (std::size_t k = 0; k < sweep_.motion.pieces().size(); ++k) {
      std::vector<Part> open{{strip_of(k, 0.0, 1.0), 0}};
      while (!open.empty()) {
        const Part part = open.back();
        open.pop_back();
        const Strip& whole = part.strip;
        const bool bounded = std::isfinite(whole.along);
        if (!bounded && part.depth == deepest) return standstill(whole);
        const bool coarse = whole.along <= 16.0 * tolerance_;  // one or two parts anyway
        if (bounded && (coarse || part.depth >= deepest_bounded)) {
          strips_.push_back(whole);
          continue;
        }
        const double middle = 0.5 * (whole.a + whole.b);
        const Strip p = strip_of(k, whole.a, middle), q = strip_of(k, middle, whole.b);
        if (bounded &&
            !(std::sqrt(p.along) + std::sqrt(q.along) < worthwhile * std::sqrt(whole.along))) {
          strips_.push_back(whole);
          continue;
        }
        open.push_back({q, part.depth + 1});
        open.push_back({p, part.depth + 1});
      }
    }
    return std::nullopt;
  }
  Fault standstill(const Strip& strip) const {
    const MotionPiece& piece = sweep_.motion.pieces()[strip.piece];
    const double xi = piece.begin + strip.a * (piece.end - piece.begin);
    return {FaultCode::zero_speed,
            "the path stands still within rounding at xi = " + to_text(xi) +
                ", where a sweep has no frame",
            strip.piece,
            "speed",
            0.0,
            std::nullopt};
  }

  // ---- round the profile

  /// Chords of at most `longest` whose share of the tolerance is `share`.
  Division division(double share, double longest) const {
    Division result;
    const double scale = sweep_.motion.largest_scale();
    const double room = 8.0 * share * tolerance_ / scale;
    for (const ProfileInterval& interval : sweep_.profile.intervals()) {
      const double chords = std::max(
          {1.0, std::ceil(std::sqrt(interval.second / room)), std::ceil(interval.first / longest)});
      add(result, interval, chords);
    }
    if (sweep_.profile.is_closed() && result.count < 3.0) {
      Division more;
      for (const ProfileInterval& interval : sweep_.profile.intervals()) add(more, interval, 3.0);
      return more;
    }
    return result;
  }
  static void add(Division& division, const ProfileInterval& interval, double chords) {
    division.chords.push_back(chords);
    division.count += chords;
    division.first = std::max(division.first, Enclosure::up(interval.first / chords));
    division.second =
        std::max(division.second, Enclosure::up(Enclosure::up(interval.second / chords) / chords));
  }

  double rings_with(const Division& division) const {
    double count = 0.0;
    for (const Strip& strip : strips_) {
      count += strip.parts(tolerance_, division.first, division.second);
    }
    return count;
  }

  /// The division with the fewest triangles, by trial.
  std::optional<Fault> find_division() {
    double length = 0.0, rounding = 0.0;
    for (const ProfileInterval& i : sweep_.profile.intervals()) length = std::max(length, i.first);
    for (const Strip& strip : strips_) rounding = std::max(rounding, strip.rounding);
    if (!(2.0 * rounding < tolerance_)) {
      return Fault{FaultCode::tolerance_not_reached,
                   "the tolerance " + to_text(options_.tolerance) +
                       " is within the rounding of the vertices; it must be above " +
                       to_text(2.0 * rounding),
                   std::nullopt,
                   "tolerance",
                   options_.tolerance,
                   2.0 * rounding};
    }
    constexpr int halvings = 16;
    double fewest = std::numeric_limits<double>::infinity();
    for (const double share : {0.15, 0.3, 0.5, 0.7}) {
      double before = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= halvings; ++i) {
        const Division trial = division(share, std::ldexp(length, -i));
        const double cells = trial.count * rings_with(trial);
        if (cells < fewest) {
          fewest = cells;
          division_ = trial;
        }
        if (std::isfinite(before) && !(cells < before)) break;
        before = cells;
      }
    }
    const double triangles = 2.0 * fewest;
    if (!(triangles <= static_cast<double>(options_.most_triangles))) {
      // The number falls with the square root of the tolerance along each direction.
      return Fault{FaultCode::tolerance_not_reached,
                   "the tolerance " + to_text(options_.tolerance) + " needs " +
                       rounded_count(triangles) + " triangles, more than the " +
                       std::to_string(options_.most_triangles) +
                       " allowed; a larger tolerance needs fewer",
                   std::nullopt,
                   "triangles",
                   triangles,
                   static_cast<double>(options_.most_triangles)};
    }
    return std::nullopt;
  }
  static std::string rounded_count(double count) {
    if (!(count < 9.0e15)) return "too many";  // beyond whole numbers
    return std::to_string(static_cast<long long>(count));
  }

  // ---- the vertices

  struct RingPlace {
    std::size_t piece;
    double v;
  };
  void place_rings() {
    for (const Strip& strip : strips_) {
      double parts = strip.parts(tolerance_, division_.first, division_.second);
      // A closed motion needs three rings for its triangles to be distinct.
      if (sweep_.motion.is_closed() && strips_.size() < 3) parts = std::max(parts, 3.0);
      result_.deviation =
          std::max(result_.deviation, strip.deviation(parts, division_.first, division_.second));
      const auto count = static_cast<std::size_t>(parts);
      for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / parts;
        rings_.push_back({strip.piece, strip.a + t * (strip.b - strip.a)});
      }
    }
    if (!sweep_.motion.is_closed()) rings_.push_back({strips_.back().piece, 1.0});
  }

  void sample_profile() {
    const auto& intervals = sweep_.profile.intervals();
    const bool closed = sweep_.profile.is_closed();
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const ProfileInterval& interval = intervals[i];
      const auto count = static_cast<std::size_t>(division_.chords[i]);
      for (std::size_t j = 0; j < count; ++j) {
        const double t = static_cast<double>(j) / static_cast<double>(count);
        const auto p =
            sweep_.profile.at(interval.piece, interval.begin + t * (interval.end - interval.begin));
        // A crease where the piece before ends in another direction.
        const bool joint = interval.begin == 0.0 && j == 0 && (closed || i > 0);
        const std::size_t before =
            interval.piece == 0 ? sweep_.profile.smooth_piece_count() - 1 : interval.piece - 1;
        add_column(p,
                   joint ? std::optional(sweep_.profile.at(before, 1.0).derivative) : std::nullopt);
      }
    }
    if (!closed) add_column(sweep_.profile.at(intervals.back().piece, 1.0), std::nullopt);
    // The cells: from the last vertex at one position to the first at the next.
    for (std::size_t c = 0; c + 1 < columns_.size(); ++c) {
      if (columns_[c].position != columns_[c + 1].position) {
        cells_.push_back({static_cast<Index>(c), static_cast<Index>(c + 1)});
      }
    }
    if (closed) {
      // A crease at the first position: its incoming side stands last.
      if (wrapping_) columns_.push_back(*wrapping_);
      const auto last = static_cast<Index>(columns_.size() - 1);
      cells_.push_back(wrapping_ ? std::array<Index, 2>{last - 1, last}
                                 : std::array<Index, 2>{last, 0});
    }
  }
  struct Column {
    Index position;
    Vector3<double> point, derivative;
  };
  void add_column(const Profile::Jet& p, const std::optional<Vector3<double>>& incoming) {
    const auto position = static_cast<Index>(positions_.size());
    if (incoming && angle_between(*incoming, p.derivative) > crease_angle) {
      const Column side{position, p.position, *incoming};
      if (positions_.empty()) wrapping_ = side;
      if (!positions_.empty()) columns_.push_back(side);
    }
    positions_.push_back(p.position);
    columns_.push_back({position, p.position, p.derivative});
  }
  static double angle_between(const Vector3<double>& a, const Vector3<double>& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b));
  }

  void fill() {
    TriangleMesh& mesh = result_.mesh;
    const std::size_t rings = rings_.size(), columns = columns_.size();
    const std::size_t positions = positions_.size();
    const bool creased = columns != positions;
    const bool with_caps = has_caps();
    const std::size_t cap_vertices = with_caps ? 2 * positions : 0;
    mesh.positions.resize(rings * positions);
    mesh.normals.resize(rings * columns + cap_vertices);
    if (creased || with_caps) mesh.position_of.resize(mesh.normals.size());
    for (std::size_t i = 0; i < rings; ++i) {
      const surface_detail::Ring ring(sweep_.motion.at(rings_[i].piece, rings_[i].v));
      if (i == 0) start_tangent_ = ring.tangent();
      if (i + 1 == rings) end_tangent_ = ring.tangent();
      Vector3<double>* const to = mesh.positions.data() + i * positions;
      for (std::size_t j = 0; j < positions; ++j) to[j] = ring.position(positions_[j]);
      Vector3<double>* const normals = mesh.normals.data() + i * columns;
      for (std::size_t j = 0; j < columns; ++j) {
        normals[j] = ring.normal(columns_[j].point, columns_[j].derivative);
      }
      if (!mesh.position_of.empty()) {
        for (std::size_t j = 0; j < columns; ++j) {
          mesh.position_of[i * columns + j] =
              static_cast<Index>(i * positions) + columns_[j].position;
        }
      }
    }
    const bool closed = sweep_.motion.is_closed();
    const std::size_t bands = closed ? rings : rings - 1;
    mesh.triangles.reserve(2 * bands * cells_.size() + cap_vertices);  // fewer for the caps
    mesh.triangles.resize(2 * bands * cells_.size());
    auto* triangle = mesh.triangles.data();
    for (std::size_t i = 0; i < bands; ++i) {
      const auto here = static_cast<Index>(i * columns);
      const auto there = static_cast<Index>((i + 1 == rings ? 0 : i + 1) * columns);
      for (const auto& [left, right] : cells_) {
        *triangle++ = {here + left, here + right, there + left};
        *triangle++ = {there + left, here + right, there + right};
      }
    }
  }

  bool has_caps() const {
    return options_.caps && !sweep_.motion.is_closed() && sweep_.profile.is_closed() &&
           sweep_.profile.is_planar();
  }

  std::optional<Fault> add_caps() {
    if (!has_caps()) return std::nullopt;
    std::vector<Vector2<double>> corners;
    for (const auto& p : positions_) corners.push_back({p.y, p.z});
    const auto inside = surface_detail::triangulated(corners);
    if (!inside) {
      return Fault{FaultCode::unsupported,
                   "within the tolerance " + to_text(options_.tolerance) +
                       " the profile meets itself, so that the ends cannot be closed; take a "
                       "smaller tolerance, or leave the ends open",
                   std::nullopt,
                   "tolerance",
                   options_.tolerance,
                   std::nullopt};
    }
    TriangleMesh& mesh = result_.mesh;
    const std::size_t positions = positions_.size();
    const std::size_t start = rings_.size() * columns_.size(), end = start + positions;
    const std::size_t last_ring = (rings_.size() - 1) * positions;
    for (std::size_t j = 0; j < positions; ++j) {
      mesh.position_of[start + j] = static_cast<Index>(j);
      mesh.normals[start + j] = -start_tangent_;
      mesh.position_of[end + j] = static_cast<Index>(last_ring + j);
      mesh.normals[end + j] = end_tangent_;
    }
    const auto s = static_cast<Index>(start), e = static_cast<Index>(end);
    for (const auto& [a, b, c] : *inside) mesh.triangles.push_back({s + a, s + c, s + b});
    for (const auto& [a, b, c] : *inside) mesh.triangles.push_back({e + a, e + b, e + c});
    result_.cap_triangles = 2 * inside->size();
    return std::nullopt;
  }

  const Sweep& sweep_;
  const SweepMeshOptions& options_;
  double tolerance_ = 0.0, seam_ = 0.0;
  std::vector<Strip> strips_;
  Division division_;
  std::vector<RingPlace> rings_;
  std::vector<Vector3<double>> positions_;  // of the profile
  std::vector<Column> columns_;             // the vertices of a ring
  std::optional<Column> wrapping_;
  std::vector<std::array<Index, 2>> cells_;
  Vector3<double> start_tangent_{}, end_tangent_{};
  SweepMesh result_;
};

}  // namespace

Result<SweepMesh> mesh_of(const Sweep& sweep, const SweepMeshOptions& options) {
  return Mesher(sweep, options).run();
}

}  // namespace hodograph
