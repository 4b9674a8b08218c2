// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/color/ColorSpaceScene.h"

class QAction;
class QComboBox;
class QLabel;

namespace widgets {

class ColorBench;
class ColorSpaceCanvas;
class ColorSpacePanel;
class EmptyHint;
enum class SelectionChange : std::uint8_t;

/// The colours of the colour tool in space: the pixels of its image, its samples, the surfaces of its table,
/// in YCbCr, RGB, HSI or TSL. What is selected here is so in the images, and the other way round.
class ColorSpaceView final : public View {
  Q_OBJECT
 public:
  explicit ColorSpaceView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorSpaceView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  /// How soon what is shown must follow: at once what the user did, images of a camera ten times a second.
  enum class Due : std::uint8_t { kNothing, kSoon, kNow };

  void createActions();
  void createViews();
  QWidget* createToolRow();
  QWidget* createFooter();
  void connectSignals();
  void connectBench();

  void changed(Due due);
  ColorSpaceLook look() const;
  void updateLook();
  void updateContents();
  void updateHint();
  void updatePointed();
  void updateSelection();
  QString describe(std::size_t cell) const;
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
  int ticks_ = 0;
  std::shared_ptr<const ColorSpaceContents> contents_;
};

}  // namespace widgets
