// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "widgets/color/ColorFrame.h"

namespace widgets {

class ColorBench;

/// The images that were put aside, as a strip of small pictures. Hidden while there are none, or while it is
/// not wanted; low where there is little room. Delete removes the current one.
class ColorStrip final : public QListWidget {
  Q_OBJECT
 public:
  explicit ColorStrip(ColorBench& bench, QWidget* parent = nullptr);

  /// Marks the one that is shown; null: none of them is.
  void showCurrent(const ColorFramePtr& frame);
  void setWanted(bool wanted);
  /// Low pictures without names, for views that are not high.
  void setLow(bool low);

 Q_SIGNALS:
  void chosen(const ColorFramePtr& frame);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  QString labelOf(const ColorFrame& frame) const;

  ColorBench& bench_;
  bool wanted_ = true, low_ = false;
};

}  // namespace widgets
