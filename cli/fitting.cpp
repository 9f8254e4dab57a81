// SPDX-License-Identifier: MIT
#include "cli/fitting.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "cli/drawing.hpp"
#include "hodograph/foundation/version.hpp"

namespace hodograph::cli {
namespace {

std::string choice_text(HermiteChoice choice) {
  return choice == HermiteChoice::order_ten ? "order ten" : "order six";
}

std::string method_text(const FitOptions& options) {
  if (options.segments > 0) return "C4 Hermite, a given number of uniform segments";
  return options.knots == FitKnots::adaptive ? "C4 Hermite, adaptive knots"
                                             : "C4 Hermite, uniform knots";
}

/// A number to three digits, for people.
std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// The distance between path and source along ξ, for the picture.
void add_error_series(ReportData& data, const SourceCurve& source, const SpatialPath<8>& path) {
  constexpr std::size_t points_a_segment = 12;
  constexpr std::size_t most_points = 4000;
  const std::size_t segments = path.segment_count();
  const std::size_t stride = std::max<std::size_t>(1, segments * points_a_segment / most_points);
  for (std::size_t k = 0; k < segments; k += stride) {
    for (std::size_t i = 0; i < points_a_segment; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / points_a_segment;
      const double xi = path.xi_of({k, u});
      data.error_xi.push_back(xi);
      data.error.push_back(norm(path.segment(k).position(u) - source.curve(xi)[0]));
    }
  }
}

}  // namespace

Result<FittedPath> fitted(const Source& source, FitOptions options) {
  const auto start = std::chrono::steady_clock::now();
  auto curve = curve_of(source);
  if (!curve) return curve.fault();
  options.closed = options.closed || curve->closed;
  auto made = fit(curve->curve, curve->begin, curve->end, options, curve->measure);
  if (!made) return made.fault();

  PathDocument document{AnyPath(std::move(made->path))};
  document.name = curve->title;
  document.length_unit = curve->length_unit;
  document.parameter_unit = curve->parameter_unit;
  document.provenance.program = std::string("hodograph ") + version;
  document.provenance.source = describe(source);
  document.provenance.method = method_text(options);
  document.provenance.choice = choice_text(options.choice);
  if (options.segments == 0) document.provenance.tolerance = options.tolerance;

  FittedPath result{std::move(document), {}, *std::move(curve), made->error, 0.0};
  result.facts = facts_of(result.document.path);
  result.document.promises = promises_of(result.facts);
  result.document.promises.error =
      ErrorPromise{made->error.error, made->error.certified, compared_with(source)};
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Result<ErrorBound> error_against(const Source& source, const AnyPath& path) {
  const auto* const spatial = path.get_if<SpatialPath<8>>();
  if (spatial == nullptr) {
    return Fault{
        FaultCode::unsupported,
        "the error can be recomputed for paths in space of degree 17; this one has degree " +
            std::to_string(path.degree()) + " in " + std::to_string(path.dimension()) +
            " dimensions",
        std::nullopt,
        "degree",
        static_cast<double>(path.degree()),
        std::nullopt};
  }
  const auto curve = curve_of(source);
  if (!curve) return curve.fault();
  if (!(curve->begin <= path.xi_begin() && path.xi_end() <= curve->end)) {
    return Fault{FaultCode::outside_domain,
                 "the path runs over [" + to_text(path.xi_begin()) + ", " + to_text(path.xi_end()) +
                     "], its source over [" + to_text(curve->begin) + ", " + to_text(curve->end) +
                     "]",
                 std::nullopt,
                 "xi",
                 path.xi_begin(),
                 curve->begin};
  }
  ErrorBound total = curve->measure(spatial->segment(0), spatial->knots()[0], spatial->knots()[1]);
  for (std::size_t k = 1; k < spatial->segment_count(); ++k) {
    total = larger_error(
        total, curve->measure(spatial->segment(k), spatial->knots()[k], spatial->knots()[k + 1]));
  }
  return total;
}

ReportData report_of(const PathDocument& document, const PathFacts& facts,
                     const std::string& document_name) {
  ReportData data;
  data.title = document.name.empty() ? "A Pythagorean-hodograph path" : document.name;
  data.document_name = document_name;
  data.segments = document.path.segment_count();
  data.preimage_degree = document.path.preimage_degree();
  data.closed = document.path.is_closed();
  data.length_unit = document.length_unit;
  data.parameter_unit = document.parameter_unit;
  data.promises = document.promises;
  data.tolerance = document.provenance.tolerance;
  if (!document.provenance.method.empty()) {
    data.more.emplace_back("Method",
                           document.provenance.method + (document.provenance.choice.empty()
                                                             ? std::string()
                                                             : ", " + document.provenance.choice));
  }
  if (!document.provenance.source.empty()) {
    data.more.emplace_back("Fitted to", document.provenance.source);
  }
  if (facts.holonomy) {
    data.more.emplace_back(
        "Frame after one round",
        "rolled by " + rounded(facts.holonomy->roll) + " rad" +
            (facts.antiperiodic ? "; the preimage returns to its negative" : ""));
  }
  data.dimension = document.path.dimension();
  data.knots = document.path.knots();
  add_drawing(data, document);
  return data;
}

ReportData report_of(const FittedPath& fit, const std::string& document_name) {
  ReportData data = report_of(fit.document, fit.facts, document_name);
  data.summary = "Fitted by a Pythagorean-hodograph path of degree " +
                 std::to_string(fit.document.path.degree()) +
                 ", whose arc length is an exact polynomial and whose moving frame is exact.";
  data.seconds = fit.seconds;
  add_error_series(data, fit.source, *fit.document.path.get_if<SpatialPath<8>>());
  return data;
}

}  // namespace hodograph::cli
