// SPDX-License-Identifier: MIT
#include "cli/source.hpp"

#include <charconv>
#include <string_view>
#include <utility>

#include "hodograph/construction/fit_spline.hpp"
#ifdef HODOGRAPH_HAS_CERTIFY
#include "hodograph/certify/certified_error.hpp"
#endif
#ifdef HODOGRAPH_HAS_ORBIT
#include "hodograph/orbit/orbit_curve.hpp"
#endif

namespace hodograph::cli {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

// ---- the text of a source: "kind: body; key value; key value"
// --------------------------------------

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Cuts the part after the last `separator` off `text`.
std::optional<std::string> cut_last(std::string& text, std::string_view separator) {
  const std::size_t at = text.rfind(separator);
  if (at == std::string::npos) return std::nullopt;
  std::string tail = text.substr(at + separator.size());
  text.resize(at);
  return tail;
}

constexpr std::string_view formula_kind = "formula: ", orbit_kind = "orbit: ";

std::optional<Source> named_formula(std::string text) {
  const auto end = cut_last(text, " to ");
  const auto begin = cut_last(text, "; t from ");
  if (!end || !begin) return std::nullopt;
  const auto a = number_in(*begin), b = number_in(*end);
  if (!a || !b) return std::nullopt;
  return FormulaSource{text, *a, *b};
}

std::optional<Source> named_orbit(std::string text) {
  OrbitSource source;
  const auto unit = cut_last(text, "; in ");
  const auto revolutions = cut_last(text, "; revolutions ");
  const auto frame = cut_last(text, "; frame ");
  if (!unit || !revolutions || !frame) return std::nullopt;
  const auto count = number_in(*revolutions);
  constexpr double most = 1e6;  // read back from a text: anything a size_t holds well
  if (!count || !(*count >= 1 && *count <= most)) return std::nullopt;
  source.revolutions = static_cast<std::size_t>(*count);
  source.kilometres = *unit == "km";
  source.inertial = *frame == "inertial";
  if (const auto ratio = cut_last(text, "; mu ")) {
    source.mass_ratio = number_in(*ratio);
    if (!source.mass_ratio) return std::nullopt;
  }
  source.name = text;
  if (text != "gateway" && text != "synodic-9-2") {
    std::string start = text;
    auto numbers = cut_last(start, "initial ");
    if (!numbers || !start.empty()) return std::nullopt;
    std::vector<double> values;
    std::string rest = *numbers;
    while (const auto last = cut_last(rest, ",")) {
      const auto value = number_in(*last);
      if (!value) return std::nullopt;
      values.insert(values.begin(), *value);
    }
    const auto first = number_in(rest);
    if (!first || values.size() < 2 || values.size() > 3) return std::nullopt;
    source.name = "initial";
    source.x = *first;
    source.z = values[0];
    source.vy = values[1];
    if (values.size() == 3) source.period = values[2];
  }
  return source;
}

// ---- formulas and samples
// -------------------------------------------------------------------------

Result<SourceCurve> formula_curve(const FormulaSource& source) {
  auto formula = Formula::parse(source.formula);
  if (!formula) return formula.fault();
  SourceCurve result;
  result.curve = differentiated(*formula);
  result.begin = source.begin;
  result.end = source.end;
  result.title = source.formula;
#ifdef HODOGRAPH_HAS_CERTIFY
  result.certifiable = true;
  result.measure = [formula = *formula](const SpatialPhCurve<8>& segment, double begin,
                                        double end) {
    return segment_error(formula, segment, begin, end);
  };
#endif
  return result;
}

template <std::size_t p>
Result<SourceCurve> spline_curve(const SampleSource& source) {
  auto made = InterpolatingSpline<p>::through(
      source.samples.parameters, source.samples.points,
      source.periodic ? SplineEnds::periodic : SplineEnds::not_a_knot);
  if (!made) return made.fault();
  const auto spline = std::make_shared<const InterpolatingSpline<p>>(*std::move(made));
  SourceCurve result;
  result.curve = [spline](double t) { return (*spline)(t); };
  result.begin = spline->begin();
  result.end = spline->end();
  result.closed = source.periodic;
  result.certifiable = true;
  result.measure = [spline](const SpatialPhCurve<8>& segment, double begin, double end) {
    return spline_error(*spline, segment, begin, end);
  };
  result.length_unit = source.samples.length_unit;
  result.parameter_unit = source.samples.parameter_unit;
  result.title = source.name;
  return result;
}

// ---- orbits
// ---------------------------------------------------------------------------------------

#ifdef HODOGRAPH_HAS_ORBIT
Result<SourceCurve> orbit_curve(const OrbitSource& source) {
  const auto orbit = periodic_orbit(source);
  if (!orbit) return orbit.fault();
  const auto curve = OrbitCurve::make(
      *orbit, source.inertial ? OrbitFrame::earth_centred_inertial : OrbitFrame::rotating,
      OrbitParameter::time, source.revolutions);
  if (!curve) return curve.fault();
  SourceCurve result;
  const double unit = source.kilometres ? orbit->system.length_unit_km : 1.0;
  result.curve = [curve = *curve, unit](double xi) {
    auto jet = curve(xi);
    for (auto& derivative : jet) derivative = unit * derivative;
    return jet;
  };
  result.end = curve->end();
  result.closed = !source.inertial;
  result.length_unit = source.kilometres ? "km" : "LU";
  result.parameter_unit = "TU";
  const std::string name = source.name == "gateway"       ? "Lunar Gateway NRHO"
                           : source.name == "synodic-9-2" ? "9:2 synodic NRHO"
                                                          : "Periodic orbit";
  result.title =
      name + (source.inertial ? ", Earth-centred inertial frame" : ", rotating frame") +
      (source.revolutions == 1 ? std::string()
                               : ", " + std::to_string(source.revolutions) + " revolutions");
  return result;
}
#else
Result<SourceCurve> orbit_curve(const OrbitSource&) {
  return Fault{FaultCode::unsupported, "this program was built without orbits (Boost was missing)",
               std::nullopt,           "orbit",
               std::nullopt,           std::nullopt};
}
#endif

}  // namespace

#ifdef HODOGRAPH_HAS_ORBIT
Result<PeriodicOrbit> periodic_orbit(const OrbitSource& source) {
  if (source.name == "gateway") return lunar_gateway_nrho();
  if (source.name == "synodic-9-2") return synodic_9_2_nrho();
  ThreeBodySystem system = earth_moon_system;
  if (source.mass_ratio) system.mass_ratio = *source.mass_ratio;
  if (auto fault = check_system(system)) return *fault;
  SymmetricGuess guess{static_cast<long double>(source.x), static_cast<long double>(source.z),
                       static_cast<long double>(source.vy), std::nullopt};
  if (source.period) guess.period = static_cast<long double>(*source.period);
  return correct_symmetric_orbit(system, guess, HeldQuantity::z);
}
#endif

std::string describe(const Source& source) {
  return std::visit(
      Overloaded{
          [](const FormulaSource& s) {
            return std::string(formula_kind) + s.formula + "; t from " + to_text(s.begin) + " to " +
                   to_text(s.end);
          },
          [](const SampleSource& s) {
            return "samples: " + s.name + "; " + std::to_string(s.samples.parameters.size()) +
                   " points; spline of degree " + std::to_string(s.degree) +
                   (s.periodic ? "; periodic" : "; open");
          },
          [](const OrbitSource& s) {
            std::string text = std::string(orbit_kind) + s.name;
            if (s.name == "initial") {
              text += " " + to_text(s.x) + "," + to_text(s.z) + "," + to_text(s.vy);
              if (s.period) text += "," + to_text(*s.period);
            }
            if (s.mass_ratio) text += "; mu " + to_text(*s.mass_ratio);
            return text + "; frame " + (s.inertial ? "inertial" : "rotating") + "; revolutions " +
                   std::to_string(s.revolutions) + "; in " + (s.kilometres ? "km" : "LU");
          },
      },
      source);
}

std::optional<Source> named_source(const std::string& text) {
  if (text.starts_with(formula_kind)) return named_formula(text.substr(formula_kind.size()));
  if (text.starts_with(orbit_kind)) return named_orbit(text.substr(orbit_kind.size()));
  return std::nullopt;
}

Result<SourceCurve> curve_of(const Source& source) {
  auto result =
      std::visit(Overloaded{[](const FormulaSource& s) { return formula_curve(s); },
                            [](const SampleSource& s) -> Result<SourceCurve> {
                              if (s.degree == 5) return spline_curve<5>(s);
                              if (s.degree == 7) return spline_curve<7>(s);
                              return Fault{FaultCode::unsupported,
                                           "a spline of degree " + std::to_string(s.degree) +
                                               " is not offered; the degree is 5 or 7",
                                           std::nullopt,
                                           "degree",
                                           static_cast<double>(s.degree),
                                           7.0};
                            },
                            [](const OrbitSource& s) { return orbit_curve(s); }},
                 source);
  if (result && !result->measure) {
    result->measure = [curve = result->curve](const SpatialPhCurve<8>& segment, double begin,
                                              double end) {
      return estimated_error(curve, segment, begin, end);
    };
  }
  return result;
}

std::string compared_with(const Source& source) {
  return std::visit(
      Overloaded{[](const FormulaSource&) { return std::string("the formula"); },
                 [](const SampleSource& s) {
                   return "the spline of degree " + std::to_string(s.degree) +
                          " through the samples";
                 },
                 [](const OrbitSource&) { return std::string("the propagated orbit"); }},
      source);
}

}  // namespace hodograph::cli
