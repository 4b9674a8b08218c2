// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/table/ColorTable.h"

namespace colortool {

/// The pixels that move from one class to another, or to or from the background, when a table changes. A
/// plain value.
struct ClassLoss {
  std::uint8_t from = ColorClasses::kNone;
  std::uint8_t to = ColorClasses::kNone;
  /// Number of pixels that were `from` and are `to`.
  std::uint64_t pixels = 0;
  /// Share of the pixels that were `from`, 0 to 1.
  double share = 0;
  bool operator==(const ClassLoss&) const = default;
};

/// Sums up over images how many pixels a change of the table moves from each class to each other. One thread.
class StrokeEffect {
 public:
  /// Both tables must outlive this object.
  StrokeEffect(const ColorTable& before, const ColorTable& after) : before_(before), after_(after) {}

  /// Adds an image, with colors as the table expects them (corrected). The pixels in `area`, the stroke
  /// itself, do not count. Takes about 2 ns per pixel.
  void add(const robotlink::ImageView& image, const PixelArea& area = {});
  /// Returns the losses, the largest share first. Those below `leastShare` of the class's pixels, or below a
  /// thousandth of all pixels, are left out. Pixels that become background count as a loss of their class,
  /// too.
  std::vector<ClassLoss> losses(double leastShare = 0.02) const;

 private:
  const ColorTable& before_;
  const ColorTable& after_;
  /// Pixels by class before and after: [before * 256 + after].
  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(256U * 256U, 0);
};

/// Returns the pixels of a stroke that `before`, a table trained without the stroke, assigns to another
/// class: what a brush covered beside a thin line. If that is nearly all of it, because the table knows few
/// classes, only colors count that strokes of other classes touched, or nearly did. Empty if the stroke
/// excludes a class, or if still less than a tenth of it is uncontested, since then it is meant to correct
/// the table.
PixelArea contestedPixels(const Samples& samples, const Stroke& stroke, const ColorTable& before);

}  // namespace colortool
