// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/color/space/ColorSpaceRaster.h"
#include "widgets/color/space/ColorSpaceScene.h"
#include "widgets/color/space/ColorSurface.h"

namespace widgets {

/// Draws pictures of color spaces in software. The picture depends on the request only. Intermediate results
/// of the last request are kept, so that turning the space costs the drawing alone. Not thread-safe.
///
/// The scene is drawn with OpenGL instead. On computers without a graphics card, where both run on the
/// processor, this renderer takes a ninth of the time for the same points and surfaces
/// (widgets_colorspace_benchmark on two cores, 600 x 500 pixels, 94,000 colors: 20 ms against 194 ms; with
/// smooth edges 38 ms against 398 ms; with a new table 25 ms against 230 ms), and it knows the cell that each
/// pixel shows.
class ColorSpaceRenderer {
 public:
  /// Draws a picture; a smooth one takes four times as long.
  ColorSpacePicture render(std::shared_ptr<const ColorSpaceRequest> request);

 private:
  /// A cell and what strokes say about it.
  struct SampleCell {
    std::uint32_t cell = 0;
    std::uint8_t colorClass = 0;
    bool mustNotBe = false;
    auto operator<=>(const SampleCell&) const = default;
  };
  /// Everything that the surfaces depend on.
  struct SurfaceKey {
    std::shared_ptr<const colortool::ColorTable> table, reference;
    SurfacesOf surfaces = SurfacesOf::kTable;
    std::shared_ptr<const ColorLattice> lattice;
    ColorSpaceCut cut;
    /// Zero unless the cut depends on it.
    Eigen::Vector3f toViewer = Eigen::Vector3f::Zero();
    std::vector<bool> shownClasses;
    bool operator==(const SurfaceKey&) const = default;
  };
  /// The state of one call of render().
  struct Drawing;

  /// Bring the intermediate results up to date; return early if nothing changed.
  void updateCloud(const ColorSpaceContents& contents);
  void updateSamples(const colortool::Samples& samples);
  void updateSurfaces(const ColorSpaceRequest& request, const Eigen::Vector3f& toViewer);
  /// The pixels of the image, the samples, the surfaces of classes, and selected cells that nothing else
  /// shows.
  void drawPoints(Drawing& drawing);
  void drawSamples(Drawing& drawing);
  void drawSurfaces(Drawing& drawing);
  void drawSelection(Drawing& drawing);

  /// The lattice of the space that was drawn last.
  std::shared_ptr<const ColorLattice> lattice_;
  CloudMaker clouds_;
  /// The image of cloud_.
  ColorFramePtr frame_;
  std::shared_ptr<const robotlink::Image> corrected_;
  std::shared_ptr<const ColorCloud> cloud_;
  /// The lattice of cloudPlaces_.
  std::shared_ptr<const ColorLattice> cloudLattice_;
  /// Places of the cloud's points in the space.
  std::vector<Eigen::Vector3f> cloudPlaces_;
  /// The samples of sampleCells_.
  colortool::Samples samples_;
  std::vector<SampleCell> sampleCells_;
  SurfaceKey surfaceKey_;
  /// The cells that the cut keeps.
  colortool::CellSet left_;
  /// The cells that the surfaces enclose.
  colortool::CellSet inside_;
  std::vector<SurfaceFace> faces_;
  /// Frame buffers of opaque things and of surfaces, kept for their memory.
  ColorSpaceRaster solid_, surfaces_;
};

}  // namespace widgets
