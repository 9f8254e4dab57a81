// SPDX-License-Identifier: MIT
// Rational Bézier curves as a DXF drawing.
#include "hodograph/io/dxf.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "number.hpp"

namespace hodograph {
namespace {

/// Pieces whose ends are nearer than this fraction of the drawing's largest coordinate meet there:
/// 2^16 roundings, which leaves room for the conditioning of a construction, and a thousandth of
/// the distance 1e-8 of a drawing's size below which CAD programs take points for one.
constexpr double joined_gap = 0x1p-36;
/// The weights of pieces in one SPLINE are multiplied by at most this, and at least its inverse.
constexpr double largest_scale = 0x1p32;
/// The tolerance of equal knots that a SPLINE states, as a fraction of its shortest piece.
constexpr double knot_tolerance = 0x1p-20;

/// Groups of code and value, one a line each; handles as hexadecimal numbers, each given once.
class Groups {
 public:
  void text(int code, std::string_view value) {
    head(code);
    out_ += value;
    out_ += '\n';
  }
  void whole(int code, std::size_t value) {
    head(code);
    out_ += std::to_string(value);
    out_ += '\n';
  }
  void number(int code, double value) {
    head(code);
    io_detail::append_number(out_, value);
    out_ += '\n';
  }
  /// Groups `code` and `code` + 10, and + 20 where there is a z.
  void point(int code, const Vector2<double>& p) {
    number(code, p.x);
    number(code + 10, p.y);
  }
  void point(int code, const Vector2<double>& p, double z) {
    point(code, p);
    number(code + 20, z);
  }
  void handle(int code, std::uint64_t value) { text(code, hexadecimal(value)); }
  std::uint64_t new_handle() { return ++last_handle_; }

  void begin_section(std::string_view name) {
    text(0, "SECTION");
    text(2, name);
  }
  void end_section() { text(0, "ENDSEC"); }

  static std::string hexadecimal(std::uint64_t value) {
    constexpr std::uint64_t base = 16;
    std::string digits;
    for (; value > 0; value /= base) digits += "0123456789ABCDEF"[value % base];
    std::reverse(digits.begin(), digits.end());
    return digits.empty() ? "0" : digits;
  }
  std::string take() { return std::move(out_); }

 private:
  void head(int code) {
    const std::string digits = std::to_string(code);
    constexpr std::size_t width = 3;
    if (digits.size() < width) out_.append(width - digits.size(), ' ');
    out_ += digits;
    out_ += '\n';
  }

  std::string out_;
  std::uint64_t last_handle_ = 0;
};

// ---- what is drawn
// -------------------------------------------------------------------------------

/// The box of the control points, within which the curves lie.
struct Box {
  Vector2<double> lower{0.0, 0.0}, upper{0.0, 0.0};
  double largest_coordinate = 0.0;
};

Box box_of(std::span<const DxfCurves> curves) {
  Box box;
  bool first = true;
  for (const DxfCurves& layer : curves) {
    for (const RationalBezier& piece : layer.pieces) {
      for (const auto& p : piece.control_points) {
        if (std::exchange(first, false)) box.lower = box.upper = p;
        box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y)};
        box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y)};
        box.largest_coordinate = std::max({box.largest_coordinate, std::abs(p.x), std::abs(p.y)});
      }
    }
  }
  return box;
}

std::optional<Fault> fault_of(const RationalBezier& piece, std::size_t index) {
  const auto fault = [index](FaultCode code, const char* quantity, double value,
                             const std::string& sentence) {
    return Fault{code, "piece " + std::to_string(index) + sentence, index, quantity, value, {}};
  };
  const std::size_t count = piece.control_points.size();
  if (count < 2 || piece.weights.size() != count) {
    return fault(FaultCode::mismatched_size, "control_points", static_cast<double>(count),
                 " has " + std::to_string(count) + " control points and " +
                     std::to_string(piece.weights.size()) +
                     " weights; it should have two or more, and as many of both");
  }
  for (const auto& p : piece.control_points) {
    for (const double number : {p.x, p.y}) {
      if (!std::isfinite(number)) {
        return fault(FaultCode::not_finite, "control_points", number,
                     " has a control point that is infinite or not a number");
      }
    }
  }
  for (const double w : piece.weights) {
    if (!std::isfinite(w)) {
      return fault(FaultCode::not_finite, "weights", w,
                   " has a weight that is infinite or not a number");
    }
    if (!(w > 0.0)) {
      return fault(FaultCode::outside_domain, "weights", w,
                   " has the weight " + to_text(w) + "; weights should be positive");
    }
  }
  if (!std::isfinite(piece.begin) || !std::isfinite(piece.end)) {
    return fault(FaultCode::not_finite, "begin", piece.begin,
                 " covers parameters that are infinite or not a number");
  }
  if (!(piece.begin < piece.end)) {
    return fault(FaultCode::outside_domain, "begin", piece.begin,
                 " covers the parameters from " + to_text(piece.begin) + " to " +
                     to_text(piece.end) + "; they should increase");
  }
  return std::nullopt;
}

/// Joined pieces as one rational B-spline.
struct Spline {
  std::size_t degree = 0;
  std::vector<double> knots, weights;
  std::vector<Vector2<double>> points;
  double shortest_piece = 0.0;
};

/// The splines of a sequence of pieces.
class Joining {
 public:
  explicit Joining(double gap) : gap_(gap) {}

  void add(const RationalBezier& piece) {
    const std::size_t degree = piece.control_points.size() - 1;
    double scale = 1.0;
    if (splines_.empty() || !joins(piece, scale)) {
      Spline& spline = splines_.emplace_back();
      spline.degree = degree;
      spline.knots.assign(degree + 1, piece.begin);
      spline.points.push_back(piece.control_points.front());
      spline.weights.push_back(piece.weights.front());
      spline.shortest_piece = piece.end - piece.begin;
      scale = 1.0;
    }
    Spline& spline = splines_.back();
    for (std::size_t i = 1; i <= degree; ++i) {
      spline.points.push_back(piece.control_points[i]);
      spline.weights.push_back(scale * piece.weights[i]);
      spline.knots.push_back(piece.end);
    }
    spline.shortest_piece = std::min(spline.shortest_piece, piece.end - piece.begin);
  }

  /// The last knots are still to come one time more, and the weights to be brought to about 1 by a
  /// power of two: some programs take small weights for zero.
  std::vector<Spline> finished() {
    for (Spline& spline : splines_) {
      spline.knots.push_back(spline.knots.back());
      const int exponent =
          std::ilogb(*std::max_element(spline.weights.begin(), spline.weights.end()));
      for (double& w : spline.weights) w = std::scalbn(w, -exponent);
    }
    return std::move(splines_);
  }

 private:
  /// Whether a piece continues the last spline, and by what its weights are then multiplied.
  bool joins(const RationalBezier& piece, double& scale) const {
    const Spline& spline = splines_.back();
    if (spline.degree + 1 != piece.control_points.size()) return false;
    if (spline.knots.back() != piece.begin) return false;
    const Vector2<double> jump = piece.control_points.front() - spline.points.back();
    if (!(std::max(std::abs(jump.x), std::abs(jump.y)) <= gap_)) return false;
    scale = spline.weights.back() / piece.weights.front();
    return 1.0 / largest_scale <= scale && scale <= largest_scale;
  }

  double gap_;
  std::vector<Spline> splines_;
};

std::string layer_name(const std::string& name) {
  if (name.empty()) return "0";
  std::string out;
  for (const char c : name) {
    const bool printable = c >= ' ' && c <= '~';
    constexpr std::string_view forbidden = "<>/\\\":;?*|,=`";
    out += printable && forbidden.find(c) == std::string_view::npos ? c : '_';
  }
  return out;
}

// ---- the drawing around it
// -----------------------------------------------------------------------

struct Layer {
  std::string name;
  int color;
};

/// Layer 0, which every drawing has, then those of the curves, each once.
std::vector<Layer> layers_of(std::span<const DxfCurves> curves) {
  constexpr int black_on_white = 7, largest_color = 255;
  std::vector<Layer> layers = {{"0", black_on_white}};
  for (const DxfCurves& one : curves) {
    const std::string name = layer_name(one.layer);
    if (std::none_of(layers.begin(), layers.end(),
                     [&](const Layer& layer) { return layer.name == name; })) {
      layers.push_back({name, std::clamp(one.color, 1, largest_color)});
    }
  }
  return layers;
}

/// Writes the sections of a drawing in turn.
class Drawing {
 public:
  Drawing(std::span<const DxfCurves> curves, DxfUnit unit)
      : curves_(curves), unit_(unit), box_(box_of(curves)) {
    model_space_ = groups_.new_handle();
    paper_space_ = groups_.new_handle();
    root_ = groups_.new_handle();
  }

  std::string text() {
    // The header names a handle above all that are given, so it is written last.
    tables();
    blocks();
    entities();
    objects();
    const std::string body = groups_.take();
    header();
    groups_.begin_section("CLASSES");
    groups_.end_section();
    return groups_.take() + body + "  0\nEOF\n";
  }

 private:
  void header() {
    const auto variable = [this](std::string_view name) { groups_.text(9, name); };
    groups_.begin_section("HEADER");
    variable("$ACADVER");
    groups_.text(1, "AC1015");
    variable("$DWGCODEPAGE");
    groups_.text(3, "ANSI_1252");
    variable("$INSBASE");
    groups_.point(10, {0.0, 0.0}, 0.0);
    variable("$EXTMIN");
    groups_.point(10, box_.lower, 0.0);
    variable("$EXTMAX");
    groups_.point(10, box_.upper, 0.0);
    variable("$HANDSEED");
    groups_.handle(5, groups_.new_handle());
    variable("$INSUNITS");
    groups_.whole(70, static_cast<std::size_t>(unit_));
    variable("$MEASUREMENT");
    groups_.whole(70, unit_ == DxfUnit::inch || unit_ == DxfUnit::foot ? 0 : 1);
    groups_.end_section();
  }

  /// The head of a table; returns its handle, which owns the records.
  std::uint64_t begin_table(std::string_view name, std::size_t records) {
    const std::uint64_t handle = groups_.new_handle();
    groups_.text(0, "TABLE");
    groups_.text(2, name);
    groups_.handle(5, handle);
    groups_.handle(330, 0);
    groups_.text(100, "AcDbSymbolTable");
    groups_.whole(70, records);
    return handle;
  }
  void end_table() { groups_.text(0, "ENDTAB"); }
  void record(std::string_view type, std::uint64_t handle, std::uint64_t owner,
              std::string_view kind, std::string_view name) {
    groups_.text(0, type);
    groups_.handle(type == "DIMSTYLE" ? 105 : 5, handle);
    groups_.handle(330, owner);
    groups_.text(100, "AcDbSymbolTableRecord");
    groups_.text(100, kind);
    groups_.text(2, name);
  }
  void flags(std::size_t value = 0) { groups_.whole(70, value); }

  void tables() {
    groups_.begin_section("TABLES");
    view();
    line_types();
    layers();
    text_style();
    begin_table("VIEW", 0);
    end_table();
    begin_table("UCS", 0);
    end_table();
    std::uint64_t table = begin_table("APPID", 1);
    record("APPID", groups_.new_handle(), table, "AcDbRegAppTableRecord", "ACAD");
    flags();
    end_table();
    table = begin_table("DIMSTYLE", 1);
    groups_.text(100, "AcDbDimStyleTable");
    groups_.whole(71, 1);
    record("DIMSTYLE", groups_.new_handle(), table, "AcDbDimStyleTableRecord", "Standard");
    flags();
    end_table();
    table = begin_table("BLOCK_RECORD", 2);
    record("BLOCK_RECORD", model_space_, table, "AcDbBlockTableRecord", "*Model_Space");
    groups_.handle(340, 0);
    record("BLOCK_RECORD", paper_space_, table, "AcDbBlockTableRecord", "*Paper_Space");
    groups_.handle(340, 0);
    end_table();
    groups_.end_section();
  }

  /// The view in which the drawing opens: all of it, with some room.
  void view() {
    constexpr double room = 1.1, aspect = 1.5;
    constexpr std::size_t zoom = 1000;  // arcs are drawn ten times finer than by default
    const Vector2<double> middle = 0.5 * box_.lower + 0.5 * box_.upper;
    const Vector2<double> half = 0.5 * box_.upper - 0.5 * box_.lower;
    double height = 2.0 * room * std::max(half.y, half.x / aspect);
    if (!(height > 0.0 && std::isfinite(height))) height = 1.0;
    const std::uint64_t table = begin_table("VPORT", 1);
    record("VPORT", groups_.new_handle(), table, "AcDbViewportTableRecord", "*Active");
    flags();
    groups_.point(10, {0.0, 0.0});
    groups_.point(11, {1.0, 1.0});
    groups_.point(12, middle);
    groups_.point(13, {0.0, 0.0});
    groups_.point(14, {1.0, 1.0});
    groups_.point(15, {1.0, 1.0});
    groups_.point(16, {0.0, 0.0}, 1.0);
    groups_.point(17, {0.0, 0.0}, 0.0);
    groups_.number(40, height);
    groups_.number(41, aspect);
    groups_.number(42, 50.0);  // the length of the lens
    for (const int code : {43, 44, 50, 51}) groups_.number(code, 0.0);
    groups_.whole(71, 0);
    groups_.whole(72, zoom);
    groups_.whole(73, 1);
    groups_.whole(74, 3);
    for (const int code : {75, 76, 77, 78}) groups_.whole(code, 0);
    end_table();
  }

  void line_types() {
    const std::uint64_t table = begin_table("LTYPE", 3);
    for (const char* const name : {"ByBlock", "ByLayer", "Continuous"}) {
      record("LTYPE", groups_.new_handle(), table, "AcDbLinetypeTableRecord", name);
      flags();
      groups_.text(3, "");
      groups_.whole(72, 65);  // the letter A, as the format asks
      groups_.whole(73, 0);
      groups_.number(40, 0.0);
    }
    end_table();
  }

  void layers() {
    const std::vector<Layer> all = layers_of(curves_);
    const std::uint64_t table = begin_table("LAYER", all.size());
    for (const Layer& layer : all) {
      record("LAYER", groups_.new_handle(), table, "AcDbLayerTableRecord", layer.name);
      flags();
      groups_.whole(62, static_cast<std::size_t>(layer.color));
      groups_.text(6, "Continuous");
    }
    end_table();
  }

  void text_style() {
    const std::uint64_t table = begin_table("STYLE", 1);
    record("STYLE", groups_.new_handle(), table, "AcDbTextStyleTableRecord", "Standard");
    flags();
    groups_.number(40, 0.0);
    groups_.number(41, 1.0);
    groups_.number(50, 0.0);
    groups_.whole(71, 0);
    groups_.number(42, 1.0);
    groups_.text(3, "txt");
    groups_.text(4, "");
    end_table();
  }

  void blocks() {
    groups_.begin_section("BLOCKS");
    for (const bool paper : {false, true}) {
      const std::uint64_t owner = paper ? paper_space_ : model_space_;
      const std::string_view name = paper ? "*Paper_Space" : "*Model_Space";
      entity("BLOCK", owner, "0", paper);
      groups_.text(100, "AcDbBlockBegin");
      groups_.text(2, name);
      flags();
      groups_.point(10, {0.0, 0.0}, 0.0);
      groups_.text(3, name);
      groups_.text(1, "");
      entity("ENDBLK", owner, "0", paper);
      groups_.text(100, "AcDbBlockEnd");
    }
    groups_.end_section();
  }

  void entity(std::string_view type, std::uint64_t owner, std::string_view layer,
              bool in_paper_space = false) {
    groups_.text(0, type);
    groups_.handle(5, groups_.new_handle());
    groups_.handle(330, owner);
    groups_.text(100, "AcDbEntity");
    if (in_paper_space) groups_.whole(67, 1);
    groups_.text(8, layer);
  }

  void entities() {
    groups_.begin_section("ENTITIES");
    const double gap = joined_gap * box_.largest_coordinate;
    for (const DxfCurves& layer : curves_) {
      Joining joining(gap);
      for (const RationalBezier& piece : layer.pieces) joining.add(piece);
      const std::string name = layer_name(layer.layer);
      for (const Spline& one : joining.finished()) spline(one, name, gap);
    }
    groups_.end_section();
  }

  void spline(const Spline& spline, const std::string& layer, double gap) {
    constexpr std::size_t rational = 4, planar = 8;
    constexpr double least = std::numeric_limits<double>::min();
    entity("SPLINE", model_space_, layer);
    groups_.text(100, "AcDbSpline");
    groups_.point(210, {0.0, 0.0}, 1.0);
    flags(rational + planar);
    groups_.whole(71, spline.degree);
    groups_.whole(72, spline.knots.size());
    groups_.whole(73, spline.points.size());
    groups_.whole(74, 0);
    groups_.number(42, std::max(knot_tolerance * spline.shortest_piece, least));
    groups_.number(43, std::max(gap, least));
    for (const double knot : spline.knots) groups_.number(40, knot);
    for (const double weight : spline.weights) groups_.number(41, weight);
    for (const auto& point : spline.points) groups_.point(10, point, 0.0);
  }

  void objects() {
    const std::uint64_t group_dictionary = groups_.new_handle();
    groups_.begin_section("OBJECTS");
    dictionary(root_, 0);
    groups_.text(3, "ACAD_GROUP");
    groups_.handle(350, group_dictionary);
    dictionary(group_dictionary, root_);
    groups_.end_section();
  }
  void dictionary(std::uint64_t handle, std::uint64_t owner) {
    groups_.text(0, "DICTIONARY");
    groups_.handle(5, handle);
    groups_.handle(330, owner);
    groups_.text(100, "AcDbDictionary");
    groups_.whole(281, 1);
  }

  std::span<const DxfCurves> curves_;
  DxfUnit unit_;
  Box box_;
  Groups groups_;
  std::uint64_t model_space_ = 0, paper_space_ = 0, root_ = 0;
};

}  // namespace

DxfUnit dxf_unit(std::string_view name) {
  constexpr std::pair<std::string_view, DxfUnit> known[] = {
      {"in", DxfUnit::inch},       {"ft", DxfUnit::foot}, {"mm", DxfUnit::millimetre},
      {"cm", DxfUnit::centimetre}, {"m", DxfUnit::metre}, {"km", DxfUnit::kilometre}};
  for (const auto& [text, unit] : known) {
    if (text == name) return unit;
  }
  return DxfUnit::none;
}

Result<std::string> to_dxf(std::span<const DxfCurves> curves, DxfUnit unit) {
  std::size_t index = 0;
  for (const DxfCurves& layer : curves) {
    for (const RationalBezier& piece : layer.pieces) {
      if (auto fault = fault_of(piece, index++)) return *fault;
    }
  }
  return Drawing(curves, unit).text();
}

}  // namespace hodograph
