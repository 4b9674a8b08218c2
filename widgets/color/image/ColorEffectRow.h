// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <cstdint>
#include <memory>
#include <vector>

#include "colortool/scoring/StrokeEffect.h"

class QAction;
class QLabel;
class QToolButton;

namespace widgets {

class ColorBench;

/// A line that says what a stroke takes from other classes: while it is drawn in the current image,
/// afterward in the collected images as well. A button removes from the stroke the pixels that the table had
/// in another class. Hidden while there is nothing to say. GUI thread.
class ColorEffectRow final : public QWidget {
  Q_OBJECT
 public:
  /// The bench must outlive the row.
  explicit ColorEffectRow(ColorBench& bench, QWidget* parent = nullptr);

  /// A stroke begins; its effect is the difference to the current table.
  void begin();
  /// The stroke is complete.
  void end();

 private:
  /// Finds the stroke; hides the row when the stroke is gone or is no longer the last one.
  void followSamples();
  /// Computes the effect and updates text and button.
  void update();
  /// Removes the pixels that were of other classes from the stroke.
  void dropOutliers();
  /// The stroke; null: it does not exist (or no longer does).
  const colortool::Stroke* stroke() const;
  /// The losses of other classes, in the current image and at most eight collected ones.
  std::vector<colortool::ClassLoss> losses() const;
  QString textOf(const std::vector<colortool::ClassLoss>& losses) const;

  ColorBench& bench_;
  /// The table before the stroke; null: there is no stroke to report about.
  std::shared_ptr<const colortool::ColorTable> before_;
  /// Id of the last stroke before it; 0: none.
  std::uint64_t lastBefore_ = 0;
  /// Its id; 0: it is not there yet.
  std::uint64_t stroke_ = 0;
  /// Whether the stroke is being drawn, from begin() to end().
  bool drawing_ = false;
  QLabel* text_ = nullptr;
  QToolButton* drop_ = nullptr;
};

}  // namespace widgets
