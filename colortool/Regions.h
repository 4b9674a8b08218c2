// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/ColorClasses.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// A connected area of one colour class. Pixels; left and top inclusive, right and bottom exclusive.
struct Region {
  int colorClass = 0;
  int area = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
  double centerX = 0, centerY = 0;  ///< of mass, pixel centres at .5

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool operator==(const Region&) const = default;
};

/// Finds the regions of an image of classes by run-length coding of lines and union-find over runs that touch
/// (Bruce, Balch, Veloso 2000). Keeps its memory from image to image; one thread at a time.
class RegionFinder {
 public:
  struct Options {
    int minimumArea = 4;       ///< smaller regions are left out
    int maximumPerClass = 64;  ///< the largest ones are kept
  };
  explicit RegionFinder(Options options) : options_(options) {}
  void setOptions(Options options) { options_ = options; }

  /// Every pixel is looked at. Largest first within a class, classes ascending; ties by position, so that the
  /// result is always the same. Valid until the next call.
  const std::vector<Region>& findInRows(const robotlink::ImageView& classes);
  /// Only every `spacing`-th column is looked at, beginning at spacing / 2; each stands for its
  /// neighbourhood, so that areas and widths are estimates in steps of the spacing. Boxes stay inside the
  /// image.
  const std::vector<Region>& findInColumns(const robotlink::ImageView& classes, int spacing);

 private:
  struct Run {
    int line, begin, end;
    int parent;  ///< index of a run of the same region, its own for the region's first
    std::uint8_t colorClass;
  };
  void beginImage();
  /// Adds the runs of a line of `count` pixels, `stride` bytes apart.
  void addLine(int line, const std::uint8_t* pixels, int count, std::ptrdiff_t stride);
  void connectLines(std::size_t previousBegin, std::size_t previousEnd);
  int root(int run);
  /// Sums the runs up; `vertical` exchanges x and y.
  void collect(int spacing, bool vertical, int lineLimit);
  void select();

  Options options_;
  std::vector<Run> runs_;
  std::vector<int> regionOfRun_;
  std::vector<Region> all_;
  std::vector<Region> regions_;
};

}  // namespace colortool
