// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Paints a share (0 to 1) that the model has in `role` in the colour of what it means: good, a warning below
/// kGood, bad below kBad. The text says it, too.
class ShareDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  static constexpr double kGood = 0.9, kBad = 0.5;

  ShareDelegate(int role, QObject* parent) : QStyledItemDelegate(parent), role_(role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int role_;
};

}  // namespace widgets
