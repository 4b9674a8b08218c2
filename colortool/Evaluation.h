// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "colortool/ColorImage.h"
#include "colortool/ColorTable.h"

namespace colortool {

/// How well a table sorts pixels whose class is known. A plain value; pixels of several images are added up.
class Evaluation {
 public:
  static constexpr std::uint8_t kIgnored = 255;  ///< a label: nobody knows

  /// `classes`: how many there are, with class 0, the background.
  explicit Evaluation(int classes);

  void add(std::uint8_t label, std::uint8_t found, std::uint64_t pixels = 1);
  /// Labels are class numbers, one a pixel, or kIgnored; what is not labelled with a class here is passed
  /// over.
  void add(const ColorTable& table, const ColorImage& image, std::span<const std::uint8_t> labels);

  int classes() const { return classes_; }
  /// Pixels that are labelled `label` and were found to be `found`.
  std::uint64_t count(int label, int found) const;
  std::uint64_t labelled(int label) const;
  /// Share of a class's pixels that were found to be of it; 0 if there are none.
  double recall(int label) const;
  /// The mean over the classes, without background, that occur in the labels.
  double meanRecall() const;
  /// Share of the background's pixels that were found to be of one of `classes`.
  double falseColor(std::span<const std::uint8_t> classes) const;

 private:
  int classes_;
  std::vector<std::uint64_t> counts_;  // [label][found]
};

}  // namespace colortool
