// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Paints a bar behind a cell's text, as long as the share (0 to 1) that the model has in `role`.
class BarDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  BarDelegate(int role, QObject* parent) : QStyledItemDelegate(parent), role_(role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int role_;
};

}  // namespace widgets
