// SPDX-License-Identifier: MIT
// The report on a path: one HTML file with a table and pictures. It opens from disk without a
// network, reads on a phone and on paper, in light and in dark.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/io/document.hpp"
#include "hodograph/io/svg.hpp"

namespace hodograph {

/// Everything a report shows, as plain data. What is absent or empty is left out.
struct ReportData {
  std::string title{};          ///< "Near-rectilinear halo orbit"
  std::string summary{};        ///< one or two sentences under the title
  std::string document_name{};  ///< the file that holds the path

  // ---- the table
  std::size_t segments = 0;
  std::size_t preimage_degree = 0;
  bool closed = false;
  std::string length_unit{}, parameter_unit{};
  Promises promises{};
  std::optional<double> tolerance{};
  std::optional<double> seconds{};                          ///< the time taken
  std::vector<std::pair<std::string, std::string>> more{};  ///< further rows: name and text

  // ---- the pictures: first ones under a heading of their own, the path, then quantities along ξ
  std::string first_heading{};
  std::vector<Plot> first{};
  /// Drawings of other kinds under that heading: captions and <svg> elements.
  std::vector<std::pair<std::string, std::string>> drawings{};
  FramedPolyline path{};
  std::vector<Series> surroundings{};       ///< drawn under a path in the plane, e.g. obstacles
  std::optional<double> curvature_limit{};  ///< drawn beside the curvature
  std::size_t dimension = 3;
  std::vector<double> knots{};  ///< parameters; shown where there are few
  std::vector<double> xi{};     ///< where the next four are sampled
  std::vector<double> speed{};
  std::vector<double> curvature{};
  std::vector<double> torsion{};             ///< not a number where it does not exist
  std::vector<Vector3<double>> body_rate{};  ///< χ per unit ξ; in the plane (0, 0, χ)
  std::vector<double> error_xi{}, error{};   ///< distance to what the path stands for
  std::vector<Plot> further{};               ///< at the end of those along the path
};

/// The rows of the table, name and text, as they stand in the report and on a terminal: segments,
/// position error and whether it is certified, length, smallest and largest speed, continuity at
/// the knots where segments meet, time taken. Numbers are rounded to a few digits, a lower bound
/// down and an upper bound up.
std::vector<std::pair<std::string, std::string>> report_rows(const ReportData& data);

/// The rows as aligned lines of text for a terminal, each ended by a line feed.
std::string report_text(const ReportData& data);

/// The pictures of the report: three projections (or the plane), σ, κ, τ, χ, and the error.
std::vector<Plot> report_plots(const ReportData& data);

/// The report as one HTML page (UTF-8), without scripts and without anything outside the file.
std::string report_html(const ReportData& data);

}  // namespace hodograph
