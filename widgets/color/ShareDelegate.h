// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace widgets {

/// Item delegate that paints a cell's text in a color for the share (0 to 1) that the model returns for a
/// role: good from kGood on, a warning below it, bad below kBad. The text contains the share as well, so
/// color is not the only cue. GUI thread.
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
