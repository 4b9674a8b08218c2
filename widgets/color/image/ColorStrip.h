// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "widgets/color/ColorFrame.h"

namespace widgets {

class ColorBench;

/// The collected images as a strip of thumbnails. Hidden while there are none or it is not wanted. Delete
/// removes the current image. GUI thread.
class ColorStrip final : public QListWidget {
  Q_OBJECT
 public:
  /// The bench must outlive the strip.
  explicit ColorStrip(ColorBench& bench, QWidget* parent = nullptr);

  /// Marks an image as the current one; null: none.
  void showCurrent(const ColorFramePtr& frame);
  /// Whether the user wants to see the strip.
  void setWanted(bool wanted);
  /// Low thumbnails without names, for views with little height.
  void setLow(bool low);

 Q_SIGNALS:
  /// The user chose an image.
  void chosen(const ColorFramePtr& frame);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Marks the image that the bench works on, if it is in the strip.
  void markShown();
  /// Lists the bench's collected images.
  void refresh();
  QString labelOf(const ColorFrame& frame) const;

  ColorBench& bench_;
  bool wanted_ = true, low_ = false;
};

}  // namespace widgets
