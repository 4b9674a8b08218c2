// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/SolutionDelegate.h"

#include <QPainter>
#include <QTreeView>

#include "widgets/Theme.h"
#include "widgets/solutions/SolutionModel.h"

namespace widgets {
namespace {

constexpr int kRadioSpace = 20;

void paintRadio(QPainter& painter, const QRect& rect, SolutionModel::Choice choice, const QPalette& palette) {
  const bool marked = choice == SolutionModel::Choice::kActive || choice == SolutionModel::Choice::kPending;
  QColor color = palette.color(QPalette::Text);
  if (choice == SolutionModel::Choice::kActive) color = colorOf(Meaning::kGood, palette);
  if (choice == SolutionModel::Choice::kPending) color = colorOf(Meaning::kWarning, palette);
  if (choice == SolutionModel::Choice::kUnavailable) color = colorOf(Meaning::kMuted, palette);
  const QPointF center = QRectF(rect).center();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1.3));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(center, 5.5, 5.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  if (marked)
    painter.drawPie(QRectF(center.x() - 3, center.y() - 3, 6, 6), 90 * 16,
                    (choice == SolutionModel::Choice::kActive ? 360 : 180) * 16);
  painter.restore();
}

}  // namespace

void SolutionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
  const QVariant choice = index.data(SolutionModel::kChoiceRole);
  QStyleOptionViewItem text = option;
  if (!choice.isValid() || index.column() != SolutionModel::kName) {
    // Solutions have no process of their own, so their help or reason may use the room of that column.
    const auto* tree = qobject_cast<const QTreeView*>(option.widget);
    if (choice.isValid() && index.column() == SolutionModel::kState && tree != nullptr) {
      text.rect.setLeft(option.rect.left() - tree->columnWidth(SolutionModel::kProcess));
    }
    QStyledItemDelegate::paint(painter, text, index);
    return;
  }
  text.rect.setLeft(option.rect.left() + kRadioSpace);
  QStyledItemDelegate::paint(painter, text, index);
  const QRect radio(option.rect.left(), option.rect.top(), kRadioSpace, option.rect.height());
  paintRadio(*painter, radio, static_cast<SolutionModel::Choice>(choice.toInt()), option.palette);
}

QSize SolutionDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  if (index.column() == SolutionModel::kName) size.rwidth() += kRadioSpace;
  return {size.width(), std::max(size.height(), 20)};
}

}  // namespace widgets
