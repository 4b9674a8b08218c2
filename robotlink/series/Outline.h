// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/series/Series.h"

namespace robotlink {

/// The points of a line that looks, where [from, to) is drawn in so many columns of pixels, like one through
/// all points: of each column the first point, the smallest and the largest value, and the last point, and on
/// both sides the next point outside. Few points are returned as they are. Where a column begins or ends with
/// NaN, the line has NaN, too.
std::vector<Series::Point> outline(const Series& series, double from, double to, std::size_t columns);

}  // namespace robotlink
