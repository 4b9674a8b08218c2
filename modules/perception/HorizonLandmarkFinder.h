// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "colortool/table/ColorTable.h"
#include "modules/perception/LandmarkGeometry.h"

namespace modules {

/// Finds landmarks with scan lines across the horizon, which all of them intersect, because the camera is
/// about as high as the lower band of a beacon. Each line is read from above as a sequence of colors; pairs
/// of colors that belong to a beacon, and single ones that belong to a goal, are combined over neighboring
/// lines.
///
/// It reads only a few thousand pixels and needs no regions. Buffers are reused; one thread at a time.
class HorizonLandmarkFinder {
 public:
  struct Options {
    /// Distance between scan lines, pixels.
    int spacing = 2;
    /// The beginning of a line, pixels above the horizon.
    int above = 70;
    // The end of a line, pixels below the horizon.
    int below = 60;
    /// Minimum length of a run of one color, pixels.
    int minimumRun = 2;
    int minimumGoalLines = 4;
    LandmarkGeometry::Options geometry;
  };
  HorizonLandmarkFinder(const robotlink::FieldDescription& field, std::vector<FieldLandmark> landmarks,
                        colortool::ColorTable table, const Options& options);

  const std::vector<FieldLandmark>& landmarks() const { return landmarks_; }
  /// `image` must be kYuyv. At most one observation per landmark, in the order of landmarks().
  std::vector<LandmarkObservation> find(const robotlink::ImageView& image, const CameraView& view);

 private:
  /// A run of pixels of one class in a scan line; rows, bottom exclusive.
  struct Run {
    int colorClass, top, bottom;
  };
  /// Adjacent scan lines that show the same landmark.
  struct Cluster {
    std::size_t landmark;
    int firstColumn, lastColumn, lines;
    // Sums over the lines, for mean values.
    double topSum, bottomSum;
  };
  /// Reads the runs of a scan line.
  void scanColumn(const robotlink::ImageView& image, int column, int top, int bottom);
  /// Whether two runs of a line are the bands of a beacon.
  bool areBands(const Run& top, const Run& bottom) const;
  /// Assigns the runs of a line to landmarks.
  void readRuns(int column);
  /// Adds a line to a cluster.
  void add(std::size_t landmark, int column, int top, int bottom);
  /// Converts the clusters to observations.
  std::vector<LandmarkObservation> measured(const CameraView& view) const;

  std::vector<FieldLandmark> landmarks_;
  colortool::ColorTable table_;
  Options options_;
  LandmarkGeometry geometry_;
  /// Whether a landmark has the color of a class, indexed by class.
  std::vector<bool> wanted_;
  std::vector<Run> runs_;
  std::vector<Cluster> clusters_;
};

}  // namespace modules
