// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Item delegate that paints a bar behind a cell's text, as long as the share (0 to 1) that the model returns
/// for a role, and in the color of its meaning: good from kGood on, a warning below it, bad below kBad, where
/// the whole cell is marked. The text contains the share as well, so color is not the only cue. GUI thread.
class ShareDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// Bounds of the three colors.
  static constexpr double kGood = 0.9, kBad = 0.5;

  /// `role`: the model's role that holds the share.
  ShareDelegate(int role, QObject* parent) : QStyledItemDelegate(parent), role_(role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int role_;
};

}  // namespace widgets
