// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/behavior/OptionHistory.h"

namespace widgets {

/// Shows the states of the last minute. Object name "behaviorHistory". GUI thread.
class HistoryStrip final : public QWidget {
  Q_OBJECT
 public:
  /// The history must outlive the strip.
  explicit HistoryStrip(const OptionHistory& history, QWidget* parent = nullptr);
  /// Call it when the history is another one.
  void refresh();
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  const OptionHistory& history_;
};

}  // namespace widgets
