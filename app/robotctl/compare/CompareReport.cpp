// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/CompareReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Printable.h"
#include "robotlink/truth/PackageErrors.h"

namespace app {

using robotlink::escapedMarkup;

namespace {

// The plot of a figure, in pixels.
constexpr double kWidth = 460, kLineHeight = 22, kMargin = 10, kDotRadius = 2.5, kLabelWidth = 130;
/// The colors of variants in plots; distinct for those who see few colors, too (M. Okabe, K. Ito, 2008).
constexpr std::array<const char*, 6> kVariantColors{"#0072b2", "#d55e00", "#009e73",
                                                    "#cc79a7", "#e69f00", "#56b4e9"};

constexpr char kStyle[] = R"(
:root{color-scheme:light dark}body{font:14px/1.45 sans-serif;margin:2em auto;max-width:84em;padding:0 1em}
table{border-collapse:collapse;margin:.6em 0 2em}th,td{padding:.25em .8em;text-align:right;border-bottom:1px solid #8884}
th:first-child,td:first-child{text-align:left}th{vertical-align:bottom}h2{margin-top:2em}
tr.group td{font-weight:bold;padding-top:1.2em;border-bottom:2px solid #8888}tr:hover td{background:#8881}
.better{color:#07803a;font-weight:bold}.worse{color:#b3261e;font-weight:bold}.wide{overflow-x:auto}
code{background:#8882;padding:.1em .3em;overflow-wrap:anywhere}svg text{fill:currentColor;font-size:12px}.note{opacity:.75}
.missing{color:#b3261e}
)";

std::string csvNumber(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

/// A package or another thing whose figures stand together: "models/ball"; empty: they belong to the whole.
std::string groupOf(const std::string& figure) {
  const std::string word = figure.substr(0, figure.find(' '));
  return word.find('/') == std::string::npos ? std::string() : word;
}

/// The unit with which a figure is shown, and the factor of its numbers.
struct ShownUnit {
  std::string name;
  double factor = 1;
};

/// Errors are small: mm, degrees, ms and percent read best.
ShownUnit shownUnit(const std::string& figure, const std::string& unit) {
  if (groupOf(figure).empty()) return {unit};
  if (unit == "m") return {"mm", 1000};
  if (unit == "rad") return {"\u00b0", 180 / robotlink::kPi};
  if (unit == "s") return {"ms", 1000};
  if (unit == kShare) return {"%", 100};
  if (unit == robotlink::kShareOfTime) return {"% of the time", 100};
  return {unit};
}

/// A number with four significant digits, and its unit.
std::string numberText(double value, const ShownUnit& unit) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.4g}", unit.factor * value) + (unit.name.empty() ? "" : " " + unit.name);
}

std::string intervalText(const MeanInterval& interval, const ShownUnit& unit) {
  if (!std::isfinite(interval.low)) return numberText(interval.mean, unit);
  return fmt::format("{} <span class=note>[{:.3g}, {:.3g}]</span>", numberText(interval.mean, unit),
                     unit.factor * interval.low, unit.factor * interval.high);
}

/// Whether less of a figure is better; nothing where neither is.
std::optional<bool> isLessBetter(const std::string& figure) {
  const auto has = [&](const char* part) { return figure.find(part) != std::string::npos; };
  for (const char* part : {"conceded", "penalties", "outside", "lying", "fell", "missed", "false", "ms_per_"})
    if (has(part)) return true;
  for (const char* end : {" mean", " median", " p95"})
    if (has("/") && figure.ends_with(end)) return true;
  for (const char* part : {"won", "goals", "forward", "least_upright", "real_time_factor", "share of trials"})
    if (has(part)) return false;
  return std::nullopt;
}

/// The range that a plot shows. It begins at 0, unless the values are so far from there that they could not
/// be distinguished.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void complete() {
    if (low > high) low = high = 0;
    const double spread = high - low;
    if (low > 0 && low < 2 * spread) low = 0;
    if (high < 0 && -high < 2 * spread) high = 0;
  }
  double place(double value) const {
    const double share = high > low ? (value - low) / (high - low) : 0.5;
    return kLabelWidth + kMargin + share * (kWidth - kLabelWidth - 2 * kMargin);
  }
};

/// A name that fits beside a plot.
std::string shortened(const std::string& name) {
  constexpr std::size_t kMaxLetters = 20;
  if (name.size() <= kMaxLetters) return name;
  std::size_t end = kMaxLetters - 1;
  // The text must not end within a multi-byte character.
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return name.substr(0, end) + "\u2026";
}

std::string plotLine(const Comparison::Row& row, const std::string& variant, const char* color,
                     const Range& range, double y) {
  std::string svg = fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>", kLabelWidth, y + 4,
                                escapedMarkup(shortened(variant)));
  const auto cell = row.byVariant.find(variant);
  if (cell == row.byVariant.end()) return svg;
  const ShownUnit unit = shownUnit(row.name, row.unit);
  for (const auto& [subject, value] : cell->second.bySubject)
    svg += fmt::format(
        "<circle cx='{:.1f}' cy='{:.1f}' r='{}' fill='{}' fill-opacity='.45'><title>{}, {}: "
        "{}</title></circle>",
        range.place(value), y, kDotRadius, color, escapedMarkup(variant), escapedMarkup(subject),
        numberText(value, unit));
  const MeanInterval mean = Comparison::meanOf(row, variant);
  if (std::isfinite(mean.low))
    svg += fmt::format("<line x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}' stroke='{}' stroke-width='2'/>",
                       range.place(mean.low), range.place(mean.high), y, y, color);
  return svg + fmt::format(
                   "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}' stroke='{3}' "
                   "stroke-width='3'/>",
                   range.place(mean.mean), y - 6, y + 6, color);
}

std::string plotOf(const Comparison::Row& row, const std::vector<std::string>& variants) {
  Range range;
  for (const auto& [variant, cell] : row.byVariant) {
    for (const auto& [subject, value] : cell.bySubject) range.include(value);
    const MeanInterval mean = Comparison::meanOf(row, variant);
    range.include(mean.low);
    range.include(mean.high);
  }
  range.complete();
  const double height = kLineHeight * static_cast<double>(variants.size()) + 24;
  std::string svg = fmt::format("<svg width='{}' height='{}' role='img'>", kWidth, height);
  double y = kLineHeight / 2;
  if (range.low < 0 && range.high > 0)
    svg += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='0' y2='{1:.1f}' stroke='#8888'/>", range.place(0),
                       height - 22);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    svg += plotLine(row, variants[i], kVariantColors[i % kVariantColors.size()], range, y);
    y += kLineHeight;
  }
  const ShownUnit unit = shownUnit(row.name, row.unit);
  svg += fmt::format("<text x='{}' y='{}'>{}</text><text x='{}' y='{}' text-anchor='end'>{}</text></svg>",
                     kLabelWidth + kMargin, height - 6, numberText(range.low, unit), kWidth - kMargin,
                     height - 6, numberText(range.high, unit));
  return svg;
}

std::string plainTable(const ReportTable& table) {
  std::string html = "<h2>" + escapedMarkup(table.heading) + "</h2>\n<table>";
  const char* cell = "th";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& text : row) html += fmt::format("<{0}>{1}</{0}>", cell, escapedMarkup(text));
    html += "</tr>\n";
    cell = "td";
  }
  return html + "</table>\n";
}

using Rows = std::vector<const Comparison::Row*>;

std::string summaryTable(const Comparison& comparison, const Rows& rows) {
  std::string html = "<div class=wide><table><tr><th>figure</th>";
  for (const std::string& variant : comparison.variants()) html += "<th>" + escapedMarkup(variant) + "</th>";
  html += "<th>mean, 95 % bounds, single runs</th></tr>\n";
  std::string group, constants;
  for (const Comparison::Row* row : rows) {
    const ShownUnit unit = shownUnit(row->name, row->unit);
    if (const auto value = row->constant()) {
      constants += fmt::format("{}{} ({})", constants.empty() ? "" : ", ", escapedMarkup(row->name),
                               numberText(*value, unit));
      continue;
    }
    const std::string own = groupOf(row->name);
    if (std::exchange(group, own) != own && !own.empty())
      html += fmt::format("<tr class=group><td colspan={}>{}</td></tr>\n", comparison.variants().size() + 2,
                          escapedMarkup(own));
    html += "<tr><td>" + escapedMarkup(own.empty() ? row->name : row->name.substr(own.size() + 1)) + "</td>";
    for (const std::string& variant : comparison.variants())
      html += "<td>" +
              (row->byVariant.contains(variant) ? intervalText(Comparison::meanOf(*row, variant), unit)
                                                : std::string("-")) +
              "</td>";
    html += "<td>" + plotOf(*row, comparison.variants()) + "</td></tr>\n";
  }
  html += "</table></div>\n";
  if (!constants.empty()) html += "<p class=note>The same in all runs: " + constants + ".</p>\n";
  return html;
}

/// Whether a figure is one of what is compared above all.
bool isOwn(const ReportTitle& title, const std::string& figure) {
  return std::ranges::find(title.packages, groupOf(figure)) != title.packages.end();
}

/// The tables of all figures: those of what is compared above all come first.
std::string figureTables(const Comparison& comparison, const ReportTitle& title) {
  Rows own, others;
  for (const Comparison::Row& row : comparison.rows())
    (isOwn(title, row.name) ? own : others).push_back(&row);
  const char* note =
      "<p class=note>Means over the runs, in brackets the bounds that hold the mean with 95 % confidence "
      "(bootstrap over the runs, each of which counts once). In a run, errors of several robots are pooled, "
      "weighted by their numbers of samples; so are medians and 95 % quantiles. Each dot is a run; its "
      "tooltip says "
      "which.</p>\n";
  if (own.empty()) return std::string("<h2>Figures</h2>\n") + note + summaryTable(comparison, others);
  return fmt::format("<h2>Figures of {}</h2>\n{}{}<h2>Other figures of the same runs</h2>\n{}",
                     escapedMarkup(fmt::format("{}", fmt::join(title.packages, ", "))), note,
                     summaryTable(comparison, own), summaryTable(comparison, others));
}

/// "12 % less", colored where it is known whether that is good.
std::string changeText(const Comparison& comparison, const Difference& one) {
  const auto row = std::ranges::find(comparison.rows(), one.figure, &Comparison::Row::name);
  const MeanInterval first =
      row == comparison.rows().end() ? MeanInterval() : Comparison::meanOf(*row, one.first);
  // A change from what may be 0 has no share.
  const bool mayBeZero = first.low <= 0 && first.high >= 0;
  const double before = mayBeZero || !std::isfinite(first.mean) ? 0 : std::abs(first.mean);
  const bool isLess = one.change.mean < 0;
  const std::string amount =
      before > 0 ? fmt::format("{:.3g} % ", 100 * std::abs(one.change.mean) / before) : std::string();
  const auto lessIsBetter = isLessBetter(one.figure);
  const char* kind = !lessIsBetter ? "" : *lessIsBetter == isLess ? "better" : "worse";
  return fmt::format("<td class='{}'>{}{}</td>", kind, amount, isLess ? "less" : "more");
}

std::string differenceTable(const Comparison& comparison, const std::vector<Difference>& differences) {
  std::string rows;
  for (const Difference& one : differences) {
    if (!one.isReal()) continue;
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>{}<td>{}</td><td>{:.2g}</td><td>{}</td></tr>\n",
                        escapedMarkup(one.figure), escapedMarkup(one.first), escapedMarkup(one.second),
                        changeText(comparison, one),
                        intervalText(one.change, shownUnit(one.figure, one.unit)), one.chance, one.subjects);
  }
  if (rows.empty()) {
    const bool areFew = std::ranges::all_of(
        differences, [](const Difference& one) { return one.subjects < kFewestForChance; });
    return areFew ? fmt::format(
                        "<p>None: with fewer than {} runs of each "
                        "variant no difference is significant.</p>\n",
                        kFewestForChance)
                  : std::string(
                        "<p>None: the variants do not differ significantly in these runs. More runs may show "
                        "a difference.</p>\n");
  }
  return "<div class=wide><table><tr><th>figure</th><th>from</th><th>to</th><th></th><th>change</th>"
         "<th>by chance</th><th>runs</th></tr>\n" +
         rows + "</table></div>\n";
}

/// Returns the extent of the comparison, in a sentence.
std::string extentText(const Comparison& comparison, const std::vector<Difference>& differences) {
  std::string text;
  for (const std::string& variant : comparison.variants()) {
    std::size_t runs = 0;
    for (const Comparison::Row& row : comparison.rows())
      if (const auto cell = row.byVariant.find(variant); cell != row.byVariant.end())
        runs = std::max(runs, cell->second.bySubject.size());
    text += fmt::format("{}{} ({} run{})", text.empty() ? "" : ", ", escapedMarkup(variant), runs,
                        runs == 1 ? "" : "s");
  }
  const auto real = std::ranges::count_if(differences, &Difference::isReal);
  return fmt::format("<p>{}; {} figures, {} of {} differences are real.</p>\n", text,
                     comparison.rows().size(), real, differences.size());
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
  std::string csv = "figure,unit,from,to,runs,change,low,high,chance,real\n";
  for (const Difference& one : comparison.differences())
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csvField(one.figure), one.unit, csvField(one.first),
                    csvField(one.second), one.subjects, csvNumber(one.change.mean), csvNumber(one.change.low),
                    csvNumber(one.change.high), csvNumber(one.chance), one.isReal() ? "yes" : "no");
  return csv;
}

std::string reportHtml(const Comparison& comparison, const ReportTitle& title) {
  std::string html = "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8><title>" +
                     escapedMarkup(title.title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
                     escapedMarkup(title.title) + "</h1>\n";
  html += "<p>Made by <code>" + escapedMarkup(title.command) + "</code></p>\n";
  std::vector<Difference> differences = comparison.differences();
  std::stable_partition(differences.begin(), differences.end(),
                        [&](const Difference& one) { return isOwn(title, one.figure); });
  html += extentText(comparison, differences);
  for (const std::string& note : title.notes) html += "<p>" + escapedMarkup(note) + "</p>\n";
  for (const std::string& run : title.missing)
    html += "<p class=missing>Without a result: " + escapedMarkup(run) + "</p>\n";
  for (const ReportTable& table : title.tables) html += plainTable(table);
  html +=
      "<h2>Differences that are real</h2>\n<p class=note>Changes between two variants on the same subjects, "
      "whose 95 % bounds (bootstrap, in brackets) exclude 0, and that are not by chance: of those listed, "
      "about one in "
      "20 may be (permutation test, corrected for the number of figures). All others are in "
      "differences.csv.</p>\n" +
      differenceTable(comparison, differences);
  html += figureTables(comparison, title);
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
