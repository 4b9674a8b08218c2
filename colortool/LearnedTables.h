// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "colortool/ColorTable.h"

namespace colortool {

/// Samples of one class in one cell.
struct CellSamples {
  std::size_t cell = 0;
  std::uint8_t colorClass = ColorClasses::kNone;  ///< kNone: background
  double pixels = 0;                              ///< more than 0
};

// Tables by OpenCV's machine learning, for comparing with the votes (ColorVotes). Both look at colours as
// (0.4 Y, k (Cb - 128), k (Cr - 128)) with k = 160 / (Y + 24), so that a colour in the shade is near the same
// one in the light. From scratch each time; any thread. Without samples of a class nothing is of it.

struct GaussianOptions {
  /// Squared Mahalanobis distance from a class's mean past which a colour is not of it.
  double mostSquaredDistance = 40;
  bool operator==(const GaussianOptions&) const = default;
};
/// One Gaussian per class (cv::ml::NormalBayesClassifier). About 0.1 s.
ColorTable gaussianTable(std::span<const CellSamples> samples, const GaussianOptions& options = {});

struct SupportVectorOptions {
  double cost = 10;
  double gamma = 1.0 / 3000;  ///< of the radial basis functions, per squared value
  /// From a sample, in values of Cb and Cr, Y weighing 0.4; a colour that is farther from all of them is of
  /// no class.
  double mostDistance = 40;
  bool operator==(const SupportVectorOptions&) const = default;
};
/// A support vector machine (cv::ml::SVM, C_SVC). About 0.3 s.
ColorTable supportVectorTable(std::span<const CellSamples> samples, const SupportVectorOptions& options = {});

}  // namespace colortool
