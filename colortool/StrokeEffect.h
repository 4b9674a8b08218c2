// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/ColorTable.h"
#include "colortool/Samples.h"

namespace colortool {

/// What one class gets of another one, or of the background, when a table changes. A plain value.
struct ClassLoss {
  std::uint8_t from = ColorClasses::kNone;
  std::uint8_t to = ColorClasses::kNone;
  std::uint64_t pixels = 0;  ///< that were `from` and are `to`
  double share = 0;          ///< of all that were `from`
  bool operator==(const ClassLoss&) const = default;
};

/// Adds up, over images, what a change of the table takes from each class. One thread.
class StrokeEffect {
 public:
  /// Both must outlive this.
  StrokeEffect(const ColorTable& before, const ColorTable& after) : before_(before), after_(after) {}

  /// An image as the table sees it. What lies in `area`, the stroke itself, does not count. About 2 ns a
  /// pixel.
  void add(const robotlink::ImageView& image, const PixelArea& area = {});
  /// The largest share first. Losses of less than `leastShare` of what the class had, or less than a
  /// thousandth of all pixels, are left out. What becomes of no class is no other class's gain, but a loss
  /// all the same.
  std::vector<ClassLoss> losses(double leastShare = 0.02) const;

 private:
  const ColorTable& before_;
  const ColorTable& after_;
  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(256U * 256U, 0);
};

/// The pixels of a stroke that a table made without it takes for another class, while it takes others for
/// none or for the stroke's own: what a brush touched beside a thin line. Empty if all are of other classes,
/// since then the stroke is meant to correct them, or if less than a tenth is not.
PixelArea contestedPixels(const Samples& samples, const Stroke& stroke, const ColorTable& before);

}  // namespace colortool
