// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

// Two images in one. Pure functions; any thread. The result has the size of the first one, to which the
// second is scaled if it has another. Format_RGB32, as toQImage() makes it.
namespace widgets {

/// (1 - share) of the first image and `share`, 0 to 1, of the second.
QImage blended(const QImage& first, const QImage& second, double share);
/// The absolute difference of each color, times `gain` (1 or more): black where both are the same.
QImage difference(const QImage& first, const QImage& second, int gain);

/// The share of pixels that differ by more than `tolerance` in a color, and the largest difference.
struct DifferenceStatistics {
  double share = 0;
  int largest = 0;
};
DifferenceStatistics statisticsOf(const QImage& first, const QImage& second, int tolerance = 0);

}  // namespace widgets
