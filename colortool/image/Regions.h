// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// A connected area of one color class. In pixels; left and top are inclusive, right and bottom exclusive.
struct Region {
  int colorClass = 0;
  /// Number of pixels.
  int area = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
  /// Center of mass; the center of the upper left pixel is (0.5, 0.5).
  double centerX = 0, centerY = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool operator==(const Region&) const = default;
};

/// Finds the connected regions of an image of classes by run-length encoding of lines and union-find over
/// touching runs of equal class; runs that touch by a corner are connected, too (Bruce, Balch, Veloso 2000).
/// Reuses its memory from image to image; one thread at a time.
class RegionFinder {
 public:
  /// Limits that keep noise out of the result.
  struct Options {
    /// Regions with fewer pixels are left out.
    int minimumArea = 4;
    /// Only the largest regions of each class are kept.
    int maximumPerClass = 64;
  };
  explicit RegionFinder(Options options) : options_(options) {}
  void setOptions(Options options) { options_ = options; }

  /// Finds regions by visiting every pixel. Sorted by ascending class, then by descending area, ties by
  /// position, so that the result is deterministic. Valid until the next call.
  const std::vector<Region>& findInRows(const robotlink::ImageView& classes);
  /// Visits only every `spacing`-th column, beginning at spacing / 2. Each column represents its
  /// neighborhood, so that areas and widths are estimates in steps of the spacing. Boxes stay inside the
  /// image. Order and validity as in findInRows().
  const std::vector<Region>& findInColumns(const robotlink::ImageView& classes, int spacing);

 private:
  /// Consecutive pixels of one class in a line (a row or a column), `end` exclusive.
  struct Run {
    int line, begin, end;
    /// Union-find: index of a run of the same region, its own for the first run of the region.
    int parent;
    std::uint8_t colorClass;
  };
  void beginImage();
  /// Adds the runs of a line of `count` pixels, which are `stride` bytes apart.
  void addLine(int line, const std::uint8_t* pixels, int count, std::ptrdiff_t stride);
  /// Joins the runs from `previousEnd` on with those of the previous line, [previousBegin, previousEnd).
  void connectLines(std::size_t previousBegin, std::size_t previousEnd);
  /// The representative of a run's region; shortens the path to it.
  int root(int run);
  /// Sums up the runs of each region; `vertical` exchanges x and y.
  void collect(int spacing, bool vertical, int lineLimit);
  /// Applies the limits of the options and sorts.
  void select();

  Options options_;
  std::vector<Run> runs_;
  /// For each run that represents a region its index in all_, else -1.
  std::vector<int> regionOfRun_;
  /// All regions, before select().
  std::vector<Region> all_;
  /// The result.
  std::vector<Region> regions_;
};

}  // namespace colortool
