// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/commands/PaletteDelegate.h"

#include <QApplication>
#include <QPainter>

#include "app/robotcontrol/commands/PaletteEntries.h"
#include "widgets/Theme.h"

namespace app {
namespace {

constexpr int kRowMargin = 8;
constexpr int kColumnGap = 14;
constexpr int kLineMargin = 4;

}  // namespace

void PaletteDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  row.text.clear();
  const QWidget* view = row.widget;
  (view != nullptr ? view->style() : QApplication::style())
      ->drawControl(QStyle::CE_ItemViewItem, &row, painter, view);
  const bool isChosen = (row.state & QStyle::State_Selected) != 0;
  const QColor text = row.palette.color(isChosen ? QPalette::HighlightedText : QPalette::Text);
  const QColor muted = isChosen ? widgets::mixed(text, row.palette.color(QPalette::Highlight), 0.3)
                                : widgets::colorOf(widgets::Meaning::kMuted, row.palette);
  QRect room = row.rect.adjusted(kRowMargin, 0, -kRowMargin, 0);
  const auto draw = [&](const QString& shown, const QColor& color, int flags, int width) {
    painter->setPen(color);
    QRect place = room;
    if ((flags & Qt::AlignRight) != 0) {
      room.setRight(room.right() - width - kColumnGap);
    } else {
      room.setLeft(room.left() + width + kColumnGap);
      place.setWidth(width);
    }
    painter->drawText(place, flags | Qt::AlignVCenter | Qt::TextSingleLine,
                      row.fontMetrics.elidedText(shown, Qt::ElideRight, width));
  };
  painter->save();
  painter->setFont(row.font);
  const auto wanted = [&](const QString& shown) { return row.fontMetrics.horizontalAdvance(shown) + 2; };
  const QString key = index.data(PaletteModel::kKeyRole).toString();
  if (!key.isEmpty()) draw(key, muted, Qt::AlignRight, wanted(key));
  const QString title = index.data(Qt::DisplayRole).toString();
  draw(title, text, Qt::AlignLeft, std::min(wanted(title), room.width()));
  if (room.width() > kColumnGap)
    draw(index.data(PaletteModel::kHelpRole).toString(), muted, Qt::AlignLeft, room.width());
  painter->restore();
}

QSize PaletteDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QSize usual = QStyledItemDelegate::sizeHint(option, index);
  return {usual.width(), option.fontMetrics.height() + 2 * kLineMargin};
}

}  // namespace app
