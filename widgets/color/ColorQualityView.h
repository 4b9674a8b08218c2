// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "colortool/Evaluation.h"

#include "widgets/View.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/TrueClassFrames.h"

class QAction;
class QLabel;
class QSplitter;

namespace widgets {

class ColorBench;
class ConfusionPanel;
class LabelledFolder;

/// How good the table is, always up to date: by cross-validation over the user's own strokes, and beside it
/// over images whose classes are known: of a folder, or told by the simulator.
class ColorQualityView final : public View {
  Q_OBJECT
 public:
  explicit ColorQualityView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorQualityView() override;
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void openFolder();
  void takeRead();
  void closeImages();
  void showQuality();
  void showStrokes();
  void showLabelled();
  QString strokesNote() const;
  QString countNote() const;
  QString othersNote() const;
  /// How the table that it is compared with does, and which is better; empty without one.
  QString referenceNote(const colortool::Evaluation& own,
                        const std::optional<colortool::Evaluation>& reference,
                        const std::vector<std::uint8_t>& alone) const;
  void say(const QString& text, bool bad = false);

  ColorBench& bench_;
  ColorActions history_;
  TrueClassFrames trueClasses_;
  std::unique_ptr<LabelledFolder> reading_;
  QString folder_;  ///< where labelled images were opened last
  QAction* open_ = nullptr;
  QAction* simulated_ = nullptr;
  QAction* close_ = nullptr;
  QSplitter* splitter_ = nullptr;
  ConfusionPanel* strokes_ = nullptr;
  ConfusionPanel* labelled_ = nullptr;
  QLabel* state_ = nullptr;
  QString problem_;  ///< why there are no labelled images
};

}  // namespace widgets
