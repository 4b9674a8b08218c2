// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <memory>
#include <optional>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/table/CellSet.h"
#include "widgets/color/ColorFrame.h"
#include "widgets/color/space/ColorCloud.h"
#include "widgets/color/space/ColorLattice.h"
#include "widgets/color/space/ColorSpaceCamera.h"
#include "widgets/color/space/ColorSpaceCut.h"

// Requests for pictures of a color space and their results: immutable values that are exchanged between
// threads.
namespace widgets {

/// The data that can be shown. Immutable.
struct ColorSpaceContents {
  /// The image whose pixels are shown; null: none.
  ColorFramePtr frame;
  /// The image with its camera's correction; null: there is none.
  std::shared_ptr<const robotlink::Image> corrected;
  /// The table whose surfaces are shown and which classifies the pixels; null: none.
  std::shared_ptr<const colortool::ColorTable> table;
  /// The reference table; null: none.
  std::shared_ptr<const colortool::ColorTable> reference;
  /// The samples, and the classes of both tables.
  colortool::Samples samples;
  /// The selected cells; null: nothing is selected.
  std::shared_ptr<const colortool::CellSet> selection;

  /// The pixels as the table sees them; empty without a frame.
  robotlink::ImageView pixels() const {
    return corrected ? corrected->view() : frame ? frame->view() : robotlink::ImageView();
  }
};

/// The tables whose surfaces are shown.
enum class SurfacesOf : std::uint8_t {
  /// The surfaces of the trained table.
  kTable,
  /// The surfaces of the reference table.
  kReference,
  /// Cells with different classes in both tables, in the class of the table or, if it has none, of the
  /// reference.
  kDifference,
};

/// The user's choice of what to show, and how.
struct ColorSpaceLook {
  colortool::ColorSpace space = colortool::ColorSpace::kYCbCr;
  /// Whether pixels, samples, and surfaces are shown.
  bool pixels = true, samples = true, table = true;
  SurfacesOf surfaces = SurfacesOf::kTable;
  /// Opacity of the surfaces, 0 to 1.
  double opacity = 0.45;
  /// Names of hidden classes; "none": what has no class.
  std::vector<std::string> hidden;
  ColorSpaceCut cut;

  bool operator==(const ColorSpaceLook&) const = default;
  /// Whether a class is not hidden.
  bool shows(const std::string& className) const;
};

/// Colors that depend on the palette.
struct ColorSpaceColors {
  QColor background, highlight;
  bool operator==(const ColorSpaceColors&) const = default;
};

/// A picture to be drawn.
struct ColorSpaceRequest {
  std::shared_ptr<const ColorSpaceContents> contents;
  ColorSpaceLook look;
  ColorSpaceCamera camera;
  ColorSpaceColors colors;
  /// Size that the camera refers to, in logical pixels.
  QSizeF widget;
  /// Pixels of the picture per logical pixel.
  double ratio = 1;
  /// Whether edges are smooth, which takes four times as long.
  bool smooth = false;

  /// Size of the picture.
  QSize pixels() const { return (widget * ratio).toSize(); }
};

/// A picture that was drawn.
struct ColorSpacePicture {
  std::shared_ptr<const ColorSpaceRequest> request;
  /// Premultiplied, transparent where nothing is.
  QImage image;
  /// The cell that each pixel shows, or ColorSpaceRaster::kNoCell.
  std::vector<std::uint32_t> cells;
  std::shared_ptr<const ColorLattice> lattice;
  /// The colors of the image; null without a frame.
  std::shared_ptr<const ColorCloud> cloud;
  /// All cells that are shown, even if others hide them.
  std::shared_ptr<const colortool::CellSet> shown;
};

}  // namespace widgets
