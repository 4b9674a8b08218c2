// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

class JointsModel;

/// Paints the history of a joint's angle between its limits as a small curve. GUI thread.
class SparklineDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  SparklineDelegate(const JointsModel& model, QObject* parent) : QStyledItemDelegate(parent), model_(model) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const JointsModel& model_;
};

}  // namespace widgets
