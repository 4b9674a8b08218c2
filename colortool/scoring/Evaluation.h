// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "colortool/image/ColorImage.h"
#include "colortool/table/ColorTable.h"

namespace colortool {

/// A confusion matrix: how well a table classifies pixels whose true class is known. A plain value; add()
/// accumulates pixels of several images.
class Evaluation {
 public:
  /// The label of pixels whose class is unknown.
  static constexpr std::uint8_t kIgnored = 255;

  /// `classes`: the number of classes, including class 0, the background.
  explicit Evaluation(int classes);

  /// Counts pixels of the true class `label` that were classified as `found`. Labels that are no class here
  /// are ignored; a `found` that is none counts as background.
  void add(std::uint8_t label, std::uint8_t found, std::uint64_t pixels = 1);
  /// Classifies an image and compares it with `labels`: class numbers, one per pixel, or kIgnored. Labels
  /// that are no class here are skipped.
  void add(const ColorTable& table, const ColorImage& image, std::span<const std::uint8_t> labels);

  int classes() const { return classes_; }
  /// Number of pixels labeled `label` that were classified as `found`.
  std::uint64_t count(int label, int found) const;
  /// Number of pixels with a label.
  std::uint64_t labeled(int label) const;
  /// Share of a class's pixels that were classified correctly, 0 to 1; 0 if there are none.
  double recall(int label) const;
  /// Mean recall of all classes that occur in the labels, without the background; 0 if there are none.
  double meanRecall() const;
  /// Share of background pixels that were classified as one of `classes`, 0 to 1.
  double falseColor(std::span<const std::uint8_t> classes) const;

 private:
  int classes_;
  std::vector<std::uint64_t> counts_;  // [label][found]
};

}  // namespace colortool
