// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/CompareReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

// The plot of a figure, in pixels.
constexpr double kWidth = 460, kLineHeight = 22, kMargin = 10, kDotRadius = 2.5;

constexpr char kStyle[] = R"(
:root{color-scheme:light dark}body{font:14px/1.45 sans-serif;margin:2em auto;max-width:76em;padding:0 1em}
table{border-collapse:collapse;margin:.6em 0 2em}th,td{padding:.25em .8em;text-align:right;border-bottom:1px solid #8884}
th:first-child,td:first-child{text-align:left}h2{margin-top:2em}.real{font-weight:bold}.better{color:#07803a}
code{background:#8882;padding:.1em .3em}svg text{fill:currentColor;font-size:12px}.note{opacity:.75}
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string csvNumber(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

/// A number with four significant digits, and its unit.
std::string numberText(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.4g}", value) + (unit.empty() ? "" : " " + unit);
}

std::string intervalText(const MeanInterval& interval, const std::string& unit) {
  if (!std::isfinite(interval.low)) return numberText(interval.mean, unit);
  return fmt::format("{} <span class=note>[{:.3g}, {:.3g}]</span>", numberText(interval.mean, unit),
                     interval.low, interval.high);
}

/// The range that a plot shows.
struct Range {
  double low = 0, high = 0;

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double place(double value) const {
    return kMargin + (high > low ? (value - low) / (high - low) : 0.5) * (kWidth - 2 * kMargin);
  }
};

std::string plotLine(const Comparison::Row& row, const std::string& variant, const Range& range, double y) {
  std::string svg;
  if (const auto cell = row.byVariant.find(variant); cell != row.byVariant.end()) {
    for (const auto& [subject, value] : cell->second.bySubject)
      svg += fmt::format(
          "<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='#4a90d9' fill-opacity='.45'><title>{}: "
          "{}</title></circle>",
          range.place(value), y, kDotRadius, escaped(subject), numberText(value, row.unit));
  }
  const MeanInterval mean = Comparison::meanOf(row, variant);
  if (std::isfinite(mean.low))
    svg += fmt::format(
        "<line x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}' stroke='currentColor' stroke-width='2'/>",
        range.place(mean.low), range.place(mean.high), y, y);
  return svg + fmt::format(
                   "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}' stroke='currentColor' "
                   "stroke-width='3'/>",
                   range.place(mean.mean), y - 6, y + 6);
}

std::string plotOf(const Comparison::Row& row, const std::vector<std::string>& variants) {
  Range range;
  for (const auto& [variant, cell] : row.byVariant) {
    for (const auto& [subject, value] : cell.bySubject) range.include(value);
    const MeanInterval mean = Comparison::meanOf(row, variant);
    range.include(mean.low);
    range.include(mean.high);
  }
  const double height = kLineHeight * static_cast<double>(variants.size()) + 24;
  std::string svg = fmt::format("<svg width='{}' height='{}' role='img'>", kWidth, height);
  double y = kLineHeight / 2;
  for (const std::string& variant : variants) {
    svg += plotLine(row, variant, range, y);
    y += kLineHeight;
  }
  svg += fmt::format("<text x='{}' y='{}'>{}</text><text x='{}' y='{}' text-anchor='end'>{}</text></svg>",
                     kMargin, height - 6, numberText(range.low, row.unit), kWidth - kMargin, height - 6,
                     numberText(range.high, row.unit));
  return svg;
}

std::string plainTable(const ReportTable& table) {
  std::string html = "<h2>" + escaped(table.heading) + "</h2>\n<table>";
  const char* cell = "th";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& text : row) html += fmt::format("<{0}>{1}</{0}>", cell, escaped(text));
    html += "</tr>\n";
    cell = "td";
  }
  return html + "</table>\n";
}

std::string summaryTable(const Comparison& comparison) {
  std::string html = "<table><tr><th>figure</th>";
  for (const std::string& variant : comparison.variants()) html += "<th>" + escaped(variant) + "</th>";
  html += "<th>" + std::string("mean, 95 % bounds, single runs") + "</th></tr>\n";
  for (const Comparison::Row& row : comparison.rows()) {
    html += "<tr><td>" + escaped(row.name) + "</td>";
    for (const std::string& variant : comparison.variants())
      html += "<td>" +
              (row.byVariant.contains(variant) ? intervalText(Comparison::meanOf(row, variant), row.unit)
                                               : std::string("-")) +
              "</td>";
    html += "<td>" + plotOf(row, comparison.variants()) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

std::string differenceTable(const Comparison& comparison) {
  std::string html =
      "<table><tr><th>figure</th><th>from</th><th>to</th><th>runs</th><th>change</th><th>real</th></tr>\n";
  for (const Difference& one : comparison.differences()) {
    if (!one.isReal()) continue;
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=real>{}</td></tr>\n",
        escaped(one.figure), escaped(one.first), escaped(one.second), one.subjects,
        intervalText(one.change, one.unit), one.change.mean < 0 ? "less" : "more");
  }
  return html + "</table>\n";
}

}  // namespace

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string resultsCsv(const Comparison& comparison) {
  std::string csv = "variant,subject,figure,unit,value\n";
  for (const Comparison::Row& row : comparison.rows())
    for (const auto& [variant, cell] : row.byVariant)
      for (const auto& [subject, value] : cell.bySubject)
        csv += fmt::format("{},{},{},{},{}\n", csvField(variant), csvField(subject), csvField(row.name),
                           row.unit, csvNumber(value));
  return csv;
}

std::string summaryCsv(const Comparison& comparison) {
  std::string csv = "figure,unit,variant,runs,mean,low,high\n";
  for (const Comparison::Row& row : comparison.rows()) {
    for (const std::string& variant : comparison.variants()) {
      const auto cell = row.byVariant.find(variant);
      if (cell == row.byVariant.end()) continue;
      const MeanInterval mean = Comparison::meanOf(row, variant);
      csv += fmt::format("{},{},{},{},{},{},{}\n", csvField(row.name), row.unit, csvField(variant),
                         cell->second.bySubject.size(), csvNumber(mean.mean), csvNumber(mean.low),
                         csvNumber(mean.high));
    }
  }
  return csv;
}

std::string differencesCsv(const Comparison& comparison) {
  std::string csv = "figure,unit,from,to,runs,change,low,high,real\n";
  for (const Difference& one : comparison.differences())
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", csvField(one.figure), one.unit, csvField(one.first),
                       csvField(one.second), one.subjects, csvNumber(one.change.mean),
                       csvNumber(one.change.low), csvNumber(one.change.high), one.isReal() ? "yes" : "no");
  return csv;
}

std::string reportHtml(const Comparison& comparison, const ReportTitle& title) {
  std::string html = "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8><title>" +
                     escaped(title.title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
                     escaped(title.title) + "</h1>\n";
  html += "<p>Made by <code>" + escaped(title.command) + "</code></p>\n";
  for (const std::string& run : title.missing) html += "<p>Without a result: " + escaped(run) + "</p>\n";
  for (const ReportTable& table : title.tables) html += plainTable(table);
  html +=
      "<h2>Figures</h2>\n<p class=note>Means over the runs, in brackets the bounds that hold the mean with "
      "95 % "
      "confidence (bootstrap).</p>\n" +
      summaryTable(comparison);
  html +=
      "<h2>Differences that are real</h2>\n<p class=note>Changes between two variants on the same subjects, "
      "whose "
      "95 % bounds exclude 0. All others are in differences.csv.</p>\n" +
      differenceTable(comparison);
  return html + "</body></html>\n";
}

robotlink::Result<void> writeReport(const std::filesystem::path& folder, const Comparison& comparison,
                                    const ReportTitle& title) {
  const std::pair<const char*, std::string> files[] = {{"report.html", reportHtml(comparison, title)},
                                                       {"results.csv", resultsCsv(comparison)},
                                                       {"summary.csv", summaryCsv(comparison)},
                                                       {"differences.csv", differencesCsv(comparison)}};
  for (const auto& [name, contents] : files)
    if (auto written = robotlink::writeFileAtomically(folder / name, contents); !written) return written;
  return {};
}

}  // namespace app
