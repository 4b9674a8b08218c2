// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "colortool/table/ColorTable.h"

namespace colortool {

/// All samples of one class in one cell.
struct CellSamples {
  /// The index of the cell, as returned by ColorTable::cellOf().
  std::size_t cell = 0;
  /// kNone: background.
  std::uint8_t colorClass = ColorClasses::kNone;
  /// Number of pixels, possibly fractional; positive.
  double pixels = 0;
};

// Color tables learned with OpenCV's machine learning, as an alternative to the votes (ColorVotes). Both
// methods use the features (0.4 Y, k (Cb - 128), k (Cr - 128)) with k = 160 / (Y + 24), so that a color in
// the shade is close to the same color in the light. Each call learns from scratch; any thread. Without
// samples of a class no cell belongs to it; with fewer than two classes the table is empty.

/// Options of gaussianTable().
struct GaussianOptions {
  /// Maximum squared Mahalanobis distance from the mean of a class; colors farther away do not belong to it.
  double mostSquaredDistance = 40;
  bool operator==(const GaussianOptions&) const = default;
};
/// Fits one Gaussian per class (cv::ml::NormalBayesClassifier). About 0.1 s.
ColorTable gaussianTable(std::span<const CellSamples> samples, const GaussianOptions& options = {});

/// Options of supportVectorTable().
struct SupportVectorOptions {
  /// The penalty C of C_SVC for samples on the wrong side.
  double cost = 10;
  /// Gamma of the radial basis functions, per squared value of a channel.
  double gamma = 1.0 / 3000;
  /// Maximum distance from the nearest sample, in values of Cb and Cr with Y weighted by 0.4; colors farther
  /// away from all samples belong to no class.
  double mostDistance = 40;
  bool operator==(const SupportVectorOptions&) const = default;
};
/// Trains a support vector machine (cv::ml::SVM, C_SVC). About 0.3 s.
ColorTable supportVectorTable(std::span<const CellSamples> samples, const SupportVectorOptions& options = {});

}  // namespace colortool
