// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Outline.h"

#include <algorithm>
#include <cmath>

namespace robotlink {
namespace {

using Point = Series::Point;

/// Adds what is seen of a column: as few points as make the same line.
void addColumn(const Series& series, const Series::Column& column, std::vector<Point>& line) {
  const Point first = series[column.begin];
  const Point last = series[column.end - 1];
  line.push_back(first);
  if (column.end - column.begin == 1) return;
  const auto addValue = [&](double value) {
    if (value != line.back().value && value != last.value) line.push_back({first.time, value});
  };
  if (!column.extent.isEmpty()) {
    // The end that is nearer to the first point is passed first.
    const bool isUpward = last.value > first.value;
    addValue(isUpward ? column.extent.min : column.extent.max);
    addValue(isUpward ? column.extent.max : column.extent.min);
  }
  line.push_back(last);
}

}  // namespace

std::vector<Point> outline(const Series& series, double from, double to, std::size_t columns) {
  constexpr std::size_t kFew = 2;  // points in a column
  const std::size_t begin = series.firstFrom(from), end = std::max(begin, series.firstFrom(to));
  std::vector<Point> line;
  if (begin > 0) line.push_back(series[begin - 1]);
  if (end - begin <= kFew * columns) {
    for (std::size_t i = begin; i < end; ++i) line.push_back(series[i]);
  } else {
    for (const Series::Column& column : series.columns(from, to, columns)) addColumn(series, column, line);
  }
  if (end < series.size()) line.push_back(series[end]);
  return line;
}

}  // namespace robotlink
