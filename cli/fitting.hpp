// SPDX-License-Identifier: MIT
// From a source to a fitted path, its document and its report: what `fit`, `orbit` and the request
// "fit" have in common.
#pragma once

#include <functional>
#include <string>

#include "cli/path_facts.hpp"
#include "cli/source.hpp"
#include "hodograph/construction/fit.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {

/// A fit with everything that is said about it.
struct FittedPath {
  PathDocument document;
  PathFacts facts;
  SourceCurve source;
  ErrorBound error;
  double seconds = 0.0;  ///< the time that the fit and its promises took
};

/// Fits and collects the promises. `options.closed` is set by the source where it knows.
Result<FittedPath> fitted(const Source& source, FitOptions options);

/// The error of a path against a source, certified where that is possible.
/// Faults: those of curve_of; unsupported (the path is not spatial of degree 17, or its knots do
/// not cover the source's interval).
Result<ErrorBound> error_against(const Source& source, const AnyPath& path);

/// The report on a fit; `document_name` is the file that holds the path.
ReportData report_of(const FittedPath& fit, const std::string& document_name);
/// The report on any document.
ReportData report_of(const PathDocument& document, const PathFacts& facts,
                     const std::string& document_name);

}  // namespace hodograph::cli
