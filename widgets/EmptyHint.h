// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

class QAbstractItemView;

namespace widgets {

/// What an empty view says in its middle: why nothing is there and what to do about it. Lies over a widget
/// (for item views: over its viewport), lets the mouse through, and follows its size. Belongs to the widget
/// it lies over.
class EmptyHint final : public QLabel {
  Q_OBJECT
 public:
  explicit EmptyHint(QWidget* over);
  explicit EmptyHint(QAbstractItemView* over);
  /// An empty text hides it.
  void setHint(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
};

}  // namespace widgets
