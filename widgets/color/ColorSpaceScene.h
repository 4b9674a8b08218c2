// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <memory>
#include <optional>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/Samples.h"
#include "widgets/color/ColorCloud.h"
#include "widgets/color/ColorFrame.h"
#include "widgets/color/ColorLattice.h"
#include "widgets/color/ColorSpaceCamera.h"
#include "widgets/color/ColorSpaceCut.h"

namespace widgets {

// What is asked of a picture of a colour space, and what comes back: values that threads hand over.

/// What there is to be seen. Immutable.
struct ColorSpaceContents {
  ColorFramePtr frame;  ///< its pixels; null: none
  std::shared_ptr<const robotlink::Image>
      corrected;  ///< the pixels as the table sees them; null: as they are
  std::shared_ptr<const colortool::ColorTable> table;      ///< what classes pixels have; null: none
  std::shared_ptr<const colortool::ColorTable> reference;  ///< what it is compared with; null: nothing
  colortool::Samples samples;                              ///< and the classes of all
  std::shared_ptr<const colortool::CellSet> selection;     ///< null: nothing is selected

  robotlink::ImageView pixels() const {
    return corrected ? corrected->view() : frame ? frame->view() : robotlink::ImageView();
  }
};

/// Whose surfaces are shown.
enum class SurfacesOf : std::uint8_t {
  kTable,
  kReference,
  kDifference,  ///< cells that the reference puts elsewhere, in the table's class or, if it has none, in that
};

/// What of it the user wants to see, and how.
struct ColorSpaceLook {
  colortool::ColorSpace space = colortool::ColorSpace::kYCbCr;
  bool pixels = true, samples = true, table = true;
  SurfacesOf surfaces = SurfacesOf::kTable;
  double opacity = 0.45;            ///< of the table's surfaces, from 0 to 1
  std::vector<std::string> hidden;  ///< names of classes; "none": what is of no class
  ColorSpaceCut cut;

  bool operator==(const ColorSpaceLook&) const = default;
  bool shows(const std::string& className) const;
};

/// Colours that go with the palette.
struct ColorSpaceColors {
  QColor background, highlight;
  bool operator==(const ColorSpaceColors&) const = default;
};

struct ColorSpaceRequest {
  std::shared_ptr<const ColorSpaceContents> contents;
  ColorSpaceLook look;
  ColorSpaceCamera camera;
  ColorSpaceColors colors;
  QSizeF widget;        ///< what the camera fits the space to
  double ratio = 1;     ///< pixels of the picture for one of the widget
  bool smooth = false;  ///< takes four times as long

  QSize pixels() const { return (widget * ratio).toSize(); }
};

struct ColorSpacePicture {
  std::shared_ptr<const ColorSpaceRequest> request;
  QImage image;                      ///< premultiplied, transparent where nothing is
  std::vector<std::uint32_t> cells;  ///< of each pixel, or ColorSpaceRaster::kNoCell
  std::shared_ptr<const ColorLattice> lattice;
  std::shared_ptr<const ColorCloud> cloud;  ///< null without a frame
  std::shared_ptr<const colortool::CellSet>
      shown;  ///< all cells that show something, hidden or not by others
};

}  // namespace widgets
