// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ShareDelegate.h"

#include <QPainter>

#include "widgets/models/Theme.h"

namespace widgets {

void ShareDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const QVariant share = index.data(role_);
  if (!share.isValid()) return;
  const double value = share.toDouble();
  const Meaning meaning = value < kBad ? Meaning::kBad : value < kGood ? Meaning::kWarning : Meaning::kGood;
  QColor color = colorOf(meaning, option.palette);
  color.setAlphaF(value < kBad ? 0.5 : 0.3);
  QRectF bar = QRectF(option.rect).adjusted(2, 2, -2, -2);
  if (value >= kBad) bar.setWidth(bar.width() * value);  // what disagrees is marked as a whole
  painter->fillRect(bar, color);
}

}  // namespace widgets
