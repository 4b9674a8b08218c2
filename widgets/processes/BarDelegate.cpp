// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/BarDelegate.h"

#include <QPainter>
#include <algorithm>

#include "widgets/Theme.h"

namespace widgets {

void BarDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const double share = std::clamp(index.data(role_).toDouble(), 0.0, 1.0);
  QRectF bar = QRectF(option.rect).adjusted(2, 3, -2, -3);
  bar.setWidth(bar.width() * share);
  QColor color = colorOf(Meaning::kNote, option.palette);
  color.setAlphaF(0.35);
  painter->fillRect(bar, color);
}

}  // namespace widgets
