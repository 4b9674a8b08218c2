// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "colortool/image/Regions.h"
#include "modules/perception/LandmarkGeometry.h"

namespace modules {

/// Finds beacons as two adjacent regions in the colors of their bands, one above the other, and goals as the
/// largest region of their color that is not part of a beacon. Immutable; any thread.
class BandLandmarkFinder {
 public:
  struct Options {
    /// Pixels.
    int minimumBandArea = 4;
    /// Pixels.
    int minimumGoalArea = 60;
    LandmarkGeometry::Options geometry;
  };
  BandLandmarkFinder(const robotlink::FieldDescription& field, std::vector<FieldLandmark> landmarks,
                     const Options& options)
      : landmarks_(std::move(landmarks)), options_(options), geometry_(field, options.geometry) {}

  const std::vector<FieldLandmark>& landmarks() const { return landmarks_; }
  /// Returns at most one observation per landmark, in the order of landmarks().
  std::vector<LandmarkObservation> find(std::span<const colortool::Region> regions,
                                        const CameraView& view) const;

 private:
  /// Adds the best observation of a landmark, if there is one.
  void findBeacon(std::size_t index, std::span<const colortool::Region> regions, const CameraView& view,
                  std::vector<LandmarkObservation>& found) const;
  void findGoal(std::size_t index, std::span<const colortool::Region> regions, const CameraView& view,
                std::vector<LandmarkObservation>& found) const;

  std::vector<FieldLandmark> landmarks_;
  Options options_;
  LandmarkGeometry geometry_;
};

}  // namespace modules
