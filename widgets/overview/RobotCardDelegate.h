// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

class RobotCardModel;
struct RobotCard;

/// Paints the cards of robots: name with the color of the team, image, state, behavior, battery and link. The
/// image is above the texts, or next to them on a low and wide card. All cards have one size, which is
/// set for the room that there is. GUI thread; the model must outlive it.
class RobotCardDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  RobotCardDelegate(const RobotCardModel& model, QObject* parent)
      : QStyledItemDelegate(parent), model_(model) {}

  /// Sets the size of `cards` cards in a room. Returns true if it changed.
  bool fit(int cards, QSize room, const QFontMetrics& font);
  QSize cardSize() const { return size_; }
  /// The size at which images are seen largest; not smaller than what the texts need. A pure function.
  static QSize sizeFor(int cards, QSize room, const QFontMetrics& font);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return size_; }

 private:
  const RobotCardModel& model_;
  QSize size_{200, 200};
};

}  // namespace widgets
