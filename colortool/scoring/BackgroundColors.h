// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/table/ColorTable.h"

namespace colortool {

/// Measures, in images without labels, how much of the background colors of strokes a table classifies as
/// objects. Strokes judge each other only by their own pixels: two large strokes of one class over a wall
/// vouch for each other, however few say that the wall is background. In other images the wall counts by its
/// pixels.
///
/// Reuses its memory from image to image; one thread at a time.
class BackgroundColors {
 public:
  /// Numbers of pixels of all images that were added; the lists are by class number.
  struct Counts {
    /// All pixels, and those with a color that a stroke of the background has.
    std::uint64_t pixels = 0, background = 0;
    /// Pixels of each class, and those among them with a color of the background.
    std::vector<std::uint64_t> covered, taken;
    bool operator==(const Counts&) const = default;
  };
  /// The class numbers of `table` must be those of the samples.
  BackgroundColors(const Samples& samples, const ColorTable& table);

  /// Adds an image as the table sees it, that is, with its camera's correction.
  void add(const robotlink::ImageView& image);
  const Counts& counts() const { return counts_; }

 private:
  ColorTable table_;
  /// 1 in the cells of strokes of the background, else 0.
  ColorTable background_;
  robotlink::Image classes_, marked_;
  Counts counts_;
};

}  // namespace colortool
