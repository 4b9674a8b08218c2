// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <cstdint>
#include <memory>
#include <vector>

#include "colortool/StrokeEffect.h"

class QAction;
class QLabel;
class QToolButton;

namespace widgets {

class ColorBench;

/// Says, while a stroke is drawn and after it, what it takes away from other classes: in the image that is
/// worked on, and, once it is drawn, in those that were put aside. Offers to drop from the stroke what the
/// table knew as another class. Hidden while there is nothing to be said.
class ColorEffectRow final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorEffectRow(ColorBench& bench, QWidget* parent = nullptr);

  /// A stroke begins: what it does is compared with the table of now.
  void begin();
  /// It is drawn.
  void end();

 private:
  void followSamples();
  void update();
  void dropOutliers();
  const colortool::Stroke* stroke() const;
  std::vector<colortool::ClassLoss> losses() const;
  QString textOf(const std::vector<colortool::ClassLoss>& losses) const;

  ColorBench& bench_;
  std::shared_ptr<const colortool::ColorTable> before_;  ///< null: no stroke is looked at
  std::uint64_t lastBefore_ = 0;                         ///< id of the last stroke before it
  std::uint64_t stroke_ = 0;                             ///< its id; 0: it is not there yet
  bool drawing_ = false;
  QLabel* text_ = nullptr;
  QToolButton* drop_ = nullptr;
};

}  // namespace widgets
