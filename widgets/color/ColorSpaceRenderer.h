// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/color/ColorSpaceRaster.h"
#include "widgets/color/ColorSpaceScene.h"
#include "widgets/color/ColorSurface.h"

namespace widgets {

/// Draws colour spaces: what it is asked for and nothing else decides what the picture is. Keeps what it made
/// for the last one, so that turning around costs only the drawing. One thread.
class ColorSpaceRenderer {
 public:
  ColorSpacePicture render(std::shared_ptr<const ColorSpaceRequest> request);

 private:
  /// What some strokes say of a cell.
  struct SampleCell {
    std::uint32_t cell = 0;
    std::uint8_t colorClass = 0;
    bool mustNotBe = false;
    auto operator<=>(const SampleCell&) const = default;
  };
  /// What the last surfaces were made of.
  struct SurfaceKey {
    std::shared_ptr<const colortool::ColorTable> table, reference;
    SurfacesOf surfaces = SurfacesOf::kTable;
    std::shared_ptr<const ColorLattice> lattice;
    ColorSpaceCut cut;
    Eigen::Vector3f toViewer = Eigen::Vector3f::Zero();  ///< zero unless the cut depends on it
    std::vector<bool> shownClasses;
    bool operator==(const SurfaceKey&) const = default;
  };
  struct Drawing;

  void updateCloud(const ColorSpaceContents& contents);
  void updateSamples(const colortool::Samples& samples);
  void updateSurfaces(const ColorSpaceRequest& request, const Eigen::Vector3f& toViewer);
  void drawPoints(Drawing& drawing);
  void drawSamples(Drawing& drawing);
  void drawSurfaces(Drawing& drawing);
  void drawSelection(Drawing& drawing);

  std::shared_ptr<const ColorLattice> lattice_;
  CloudMaker clouds_;
  ColorFramePtr frame_;
  std::shared_ptr<const robotlink::Image> corrected_;
  std::shared_ptr<const ColorCloud> cloud_;
  std::shared_ptr<const ColorLattice> cloudLattice_;  ///< in whose space the places are
  std::vector<Eigen::Vector3f> cloudPlaces_;          ///< of its points
  colortool::Samples samples_;
  std::vector<SampleCell> sampleCells_;
  SurfaceKey surfaceKey_;
  colortool::CellSet left_;    ///< by the cut
  colortool::CellSet inside_;  ///< of the surfaces
  std::vector<SurfaceFace> faces_;
  ColorSpaceRaster solid_, surfaces_;
};

}  // namespace widgets
