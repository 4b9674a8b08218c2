// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/robotctl/compare/Comparison.h"
#include "robotlink/base/Error.h"

namespace app {

/// A table of a report; the first row has its titles.
struct ReportTable {
  std::string heading;
  std::vector<std::vector<std::string>> rows;
};

/// The heading of a report, besides its figures.
struct ReportTitle {
  std::string title;                 ///< "ball-model: filtered, oracle"
  std::string command;               ///< that makes it again
  std::vector<std::string> missing;  ///< runs without a result
  std::vector<ReportTable> tables = {};
  /// The packages that are compared above all; their figures come first.
  std::vector<std::string> packages = {};
  std::vector<std::string> notes = {};  ///< sentences for readers, above all figures
};

/// A text as a field of CSV.
std::string csvField(const std::string& text);
/// Each figure of each run: variant, subject, figure, unit, value.
std::string resultsCsv(const Comparison& comparison);
/// The mean of each figure and variant with its bounds.
std::string summaryCsv(const Comparison& comparison);
/// The differences of variants with their bounds, and whether they are real.
std::string differencesCsv(const Comparison& comparison);
/// A page that needs no other file: tables, and for each figure a plot of means, bounds and single runs.
std::string reportHtml(const Comparison& comparison, const ReportTitle& title);

/// Writes report.html, results.csv, summary.csv and differences.csv.
robotlink::Result<void> writeReport(const std::filesystem::path& folder, const Comparison& comparison,
                                    const ReportTitle& title);

}  // namespace app
