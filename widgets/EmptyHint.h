// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

class QAbstractItemView;

namespace widgets {

/// The text in the middle of an empty view: why nothing is there and what to do about it. A transparent label
/// that covers another widget (for item views: the viewport), is transparent for mouse events, and follows
/// the size of that widget. It is a child of the widget it covers, which therefore owns it. GUI thread.
class EmptyHint final : public QLabel {
  Q_OBJECT
 public:
  /// Covers any widget.
  explicit EmptyHint(QWidget* over);
  /// Covers the viewport of an item view.
  explicit EmptyHint(QAbstractItemView* over);
  /// Shows the text; an empty text hides the label.
  void setHint(const QString& text);
  /// The text that fits: all of it, or, in a low view, its beginning with an ellipsis; a tooltip has all
  /// of it then.
  QString shownText() const;

 protected:
  /// Follows resize events of the covered widget, and shows its tooltip.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Takes the size of the covered widget.
  void fit();
  /// The area in which the text is painted; the margin is narrower where there is little room.
  QRect room() const;
  /// Whether a text fits into a place.
  bool fits(const QString& text, const QRect& place) const;
};

}  // namespace widgets
