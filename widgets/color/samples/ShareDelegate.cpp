// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/ShareDelegate.h"

#include <QPainter>

#include "widgets/Theme.h"

namespace widgets {

void ShareDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  // The bar is painted below the text, which keeps the palette's color.
  if (const QVariant share = index.data(role_); share.isValid()) {
    const double value = share.toDouble();
    const Meaning meaning = value < kBad ? Meaning::kBad : value < kGood ? Meaning::kWarning : Meaning::kGood;
    QColor color = colorOf(meaning, option.palette);
    color.setAlphaF(value < kBad ? 0.6 : 0.35);
    QRectF bar = QRectF(option.rect).adjusted(2, 2, -2, -2);
    if (value >= kBad) bar.setWidth(bar.width() * value);  // below kBad the whole cell is marked
    painter->fillRect(bar, color);
  }
  QStyledItemDelegate::paint(painter, option, index);
}

}  // namespace widgets
