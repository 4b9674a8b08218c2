// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "colortool/ColorTable.h"
#include "modules/perception/LandmarkGeometry.h"

namespace modules {

/// Finds landmarks by scan lines across the horizon, which pierces all of them, because the camera is about
/// as high as the lower band of a beacon: each line is read from above as a sequence of colours; pairs of
/// colours that are a beacon's and single ones that are a goal's are gathered from neighbouring lines.
///
/// Looks at a few thousand pixels only and needs no regions. Keeps its memory; one thread at a time.
class HorizonLandmarkFinder {
 public:
  struct Options {
    int spacing = 2;  ///< pixels between scan lines
    int above = 70;   ///< pixels from the horizon that a line begins
    int below = 60;
    int minimumRun = 2;  ///< pixels of one colour
    int minimumGoalLines = 4;
    LandmarkGeometry::Options geometry;
  };
  HorizonLandmarkFinder(const robotlink::FieldDescription& field, std::vector<FieldLandmark> landmarks,
                        colortool::ColorTable table, const Options& options);

  const std::vector<FieldLandmark>& landmarks() const { return landmarks_; }
  /// `image` must be kYuyv. At most one observation of each landmark, in the landmarks' order.
  std::vector<LandmarkObservation> find(const robotlink::ImageView& image, const CameraView& view);

 private:
  struct Run {
    int colorClass, top, bottom;
  };
  /// Neighbouring lines that show the same landmark.
  struct Cluster {
    std::size_t landmark;
    int firstColumn, lastColumn, lines;
    double topSum, bottomSum;
  };
  void scanColumn(const robotlink::ImageView& image, int column, int top, int bottom);
  /// Whether two runs of a line are the bands of some beacon.
  bool areBands(const Run& top, const Run& bottom) const;
  void readRuns(int column);
  void add(std::size_t landmark, int column, int top, int bottom);
  std::vector<LandmarkObservation> measured(const CameraView& view) const;

  std::vector<FieldLandmark> landmarks_;
  colortool::ColorTable table_;
  Options options_;
  LandmarkGeometry geometry_;
  std::vector<bool> wanted_;  ///< by class: a landmark has this colour
  std::vector<Run> runs_;
  std::vector<Cluster> clusters_;
};

}  // namespace modules
