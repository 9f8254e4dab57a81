// SPDX-License-Identifier: MIT
// What a path is fitted to: a formula, samples, or an orbit; and the line of text that names it in
// a document, so that `check` can take it up again.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/formula.hpp"
#include "hodograph/construction/fit.hpp"
#include "hodograph/construction/interpolating_spline.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/io/table.hpp"
#ifdef HODOGRAPH_HAS_ORBIT
#include "hodograph/orbit/periodic_orbit.hpp"
#endif

namespace hodograph::cli {

struct FormulaSource {
  std::string formula;
  double begin = 0.0, end = 1.0;
};

struct SampleSource {
  CurveSamples samples;
  std::string name;        ///< how sentences call them
  std::size_t degree = 5;  ///< of the spline: 5 or 7
  bool periodic = false;
};

/// One of the built-in orbits, or one that is found from a start; numbers in LU and LU/TU.
struct OrbitSource {
  std::string name = "gateway";        ///< gateway, synodic-9-2, or initial
  double x = 0.0, z = 0.0, vy = 0.0;   ///< where name is initial
  std::optional<double> period{};      ///< TU, a guess
  std::optional<double> mass_ratio{};  ///< the Earth and the Moon without
  bool inertial = false, kilometres = false;
  std::size_t revolutions = 1;
};

using Source = std::variant<FormulaSource, SampleSource, OrbitSource>;

/// The line that names a source in a document.
std::string describe(const Source& source);
/// The source that describe() named; nothing where the text is not of this kind, or where the
/// source is not in it (samples).
std::optional<Source> named_source(const std::string& text);

/// A curve ready to be fitted.
struct SourceCurve {
  DerivativeCurve curve;
  double begin = 0.0, end = 1.0;
  bool closed = false;
  bool certifiable = false;
  ErrorMeasure measure;  ///< a certificate where certifiable, else an estimate
  std::string length_unit, parameter_unit;
  std::string title;  ///< for people
};

/// Faults: those of Formula::parse, InterpolatingSpline::through, the orbit's correction.
Result<SourceCurve> curve_of(const Source& source);

#ifdef HODOGRAPH_HAS_ORBIT
/// The orbit of a source, corrected. Faults: those of the correction.
Result<PeriodicOrbit> periodic_orbit(const OrbitSource& source);
#endif

/// How the error of a fit of this source is known, for documents and tables.
std::string compared_with(const Source& source);

}  // namespace hodograph::cli
