// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/color/space/ColorSpaceScene.h"
#include "widgets/picture/PictureView.h"

class QAction;
class QComboBox;
class QLabel;

namespace widgets {

class ColorBench;
class ColorSpaceCanvas;
class ColorSpacePanel;
class EmptyHint;
enum class SelectionChange : std::uint8_t;

/// The colors of the color tool in space: the pixels of the image, the samples, and the surfaces of the
/// table's classes, in YCbCr, RGB, HSI or TSL. The selection is shared with the image views.
///
/// Registered as "color-space". GUI thread.
class ColorSpaceView final : public PictureView {
  Q_OBJECT
 public:
  explicit ColorSpaceView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorSpaceView() override;

  /// Updates the canvas if something changed.
  void tick() override;
  /// The colors of the image that are shown, a row for each with its place in the space, how many pixels have
  /// it, and its class.
  std::optional<QString> numbers() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  /// The urgency of showing a change: the user's changes at once, images of a camera ten times a second.
  enum class Due : std::uint8_t { kNothing, kSoon, kNow };

  void createActions();
  void createViews();
  /// Choice of the space and of what is shown.
  QWidget* createToolRow();
  /// The pointed color and the selection.
  QWidget* createFooter();
  void connectSignals();
  /// Follows the bench's signals.
  void connectBench();

  /// Remembers that contents changed, for tick().
  void changed(Due due);
  /// The options of the tool row and of the panel.
  ColorSpaceLook look() const;
  /// Passes them to the canvas.
  void updateLook();
  /// Passes the bench's state to the canvas.
  void updateContents();
  void updateHint();
  /// Shows the cell under the cursor in the footer.
  void updatePointed();
  /// Shows the size of the selection in the footer.
  void updateSelection();
  /// Color, class and number of pixels of a cell.
  QString describe(std::size_t cell) const;
  /// Changes the bench's selection.
  void select(const colortool::CellSet& cells, SelectionChange change);

  ColorBench& bench_;
  ColorSpaceCanvas* canvas_ = nullptr;
  ColorSpacePanel* panel_ = nullptr;
  QComboBox* space_ = nullptr;
  QLabel *swatch_ = nullptr, *pointed_ = nullptr, *selection_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction *pixels_ = nullptr, *samplesShown_ = nullptr, *tableShown_ = nullptr;
  QAction *reset_ = nullptr, *clear_ = nullptr, *showPanel_ = nullptr;
  Due due_ = Due::kNow;
  /// Ticks since contents were updated last.
  int ticks_ = 0;
  std::shared_ptr<const ColorSpaceContents> contents_;
};

}  // namespace widgets
