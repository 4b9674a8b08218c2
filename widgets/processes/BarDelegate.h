// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Item delegate that paints a translucent horizontal bar over a cell. The length of the bar is the share (0
/// to 1) that the model returns for a role chosen by the owner; values outside are clamped, and a cell
/// without a number gets no bar. GUI thread.
class BarDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// `role`: the model's role that holds the share.
  BarDelegate(int role, QObject* parent) : QStyledItemDelegate(parent), role_(role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  /// The role that paint() reads.
  int role_;
};

}  // namespace widgets
