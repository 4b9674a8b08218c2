// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "colortool/Regions.h"
#include "modules/perception/LandmarkGeometry.h"

namespace modules {

/// Finds beacons as two regions one upon the other in the colours of their bands, and goals as the largest
/// region of their colour that belongs to no beacon.
class BandLandmarkFinder {
 public:
  struct Options {
    int minimumBandArea = 4;   ///< pixels
    int minimumGoalArea = 60;  ///< pixels
    LandmarkGeometry::Options geometry;
  };
  BandLandmarkFinder(const robotlink::FieldDescription& field, std::vector<FieldLandmark> landmarks,
                     const Options& options)
      : landmarks_(std::move(landmarks)), options_(options), geometry_(field, options.geometry) {}

  const std::vector<FieldLandmark>& landmarks() const { return landmarks_; }
  /// At most one observation of each landmark, in the landmarks' order.
  std::vector<LandmarkObservation> find(std::span<const colortool::Region> regions,
                                        const CameraView& view) const;

 private:
  void findBeacon(std::size_t index, std::span<const colortool::Region> regions, const CameraView& view,
                  std::vector<LandmarkObservation>& found) const;
  void findGoal(std::size_t index, std::span<const colortool::Region> regions, const CameraView& view,
                std::vector<LandmarkObservation>& found) const;

  std::vector<FieldLandmark> landmarks_;
  Options options_;
  LandmarkGeometry geometry_;
};

}  // namespace modules
