// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ToolRow.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QResizeEvent>
#include <algorithm>
#include <utility>

namespace widgets {

RowButton::RowButton(QWidget* parent) : QToolButton(parent) {
  setAutoRaise(true);
  QSizePolicy policy = sizePolicy();
  policy.setHorizontalPolicy(QSizePolicy::Maximum);
  setSizePolicy(policy);
}

void RowButton::setInToolRow() {
  if (std::exchange(isInToolRow_, true)) return;
  updateGeometry();
}

int RowButton::neededWidth() const {
  return QToolButton::sizeHint().width();
}

void RowButton::setLeftOut(bool leftOut) {
  if (leftOut == isLeftOut_) return;
  isLeftOut_ = leftOut;
  setFocusPolicy(leftOut ? Qt::NoFocus : Qt::TabFocus);
  updateGeometry();
}

QSize RowButton::sizeHint() const {
  const QSize size = QToolButton::sizeHint();
  return isLeftOut_ ? QSize(0, size.height()) : size;
}

QSize RowButton::minimumSizeHint() const {
  const QSize size = QToolButton::minimumSizeHint();
  return isInToolRow_ ? QSize(0, size.height()) : size;
}

ToolRow::ToolRow(QHBoxLayout& row)
    : QObject(row.parentWidget()),
      row_(row),
      more_(new QToolButton(row.parentWidget())),
      margin_(row.contentsMargins().right()) {
  more_->setObjectName(QStringLiteral("moreTools"));
  more_->setText(QStringLiteral("»"));
  more_->setAccessibleName(tr("More tools"));
  more_->setToolTip(tr("Tools that do not fit"));
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(more_);
  more_->setMenu(menu);
  more_->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
  more_->hide();
  connect(menu, &QMenu::aboutToShow, this, &ToolRow::fillMenu);
  row.parentWidget()->installEventFilter(this);
}

bool ToolRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) {
    fit(static_cast<QResizeEvent*>(event)->size().width());
  } else if (event->type() == QEvent::LayoutRequest) {
    fit(row_.parentWidget()->width());
  }
  return QObject::eventFilter(watched, event);
}

std::vector<RowButton*> ToolRow::buttons() const {
  std::vector<RowButton*> result;
  for (int i = 0; i < row_.count(); ++i) {
    auto* button = qobject_cast<RowButton*>(row_.itemAt(i)->widget());
    if (button == nullptr || button->isHidden()) continue;
    button->setInToolRow();
    result.push_back(button);
  }
  return result;
}

int ToolRow::neededWidth(const std::vector<RowButton*>& buttons) const {
  int width = row_.contentsMargins().left() + margin_, parts = 0;
  for (RowButton* button : buttons) width += button->neededWidth();
  for (int i = 0; i < row_.count(); ++i) {
    QLayoutItem* item = row_.itemAt(i);
    if (item->isEmpty() && item->spacerItem() == nullptr) continue;
    ++parts;
    if (qobject_cast<RowButton*>(item->widget()) == nullptr) width += item->minimumSize().width();
  }
  return width + std::max(0, parts - 1) * row_.spacing();
}

void ToolRow::fit(int width) {
  std::vector<RowButton*> all = buttons();
  int missing = neededWidth(all) - width;
  const int moreWidth = more_->sizeHint().width();
  const bool isNarrow = missing > 0;
  if (isNarrow) missing += moreWidth;
  for (auto button = all.rbegin(); button != all.rend(); ++button) {
    (*button)->setLeftOut(missing > 0);
    if (missing > 0) missing -= (*button)->neededWidth();
  }
  QMargins margins = row_.contentsMargins();
  const int right = margin_ + (isNarrow ? moreWidth : 0);
  if (margins.right() != right) {
    margins.setRight(right);
    row_.setContentsMargins(margins);
  }
  more_->setVisible(isNarrow);
  more_->setGeometry(width - moreWidth, 0, moreWidth, row_.parentWidget()->height());
}

void ToolRow::fillMenu() {
  QMenu& menu = *more_->menu();
  menu.clear();
  for (RowButton* button : buttons()) {
    if (!button->isLeftOut()) continue;
    if (button->menu() == nullptr) {
      menu.addAction(button->defaultAction());
    } else if (button->defaultAction() == nullptr) {
      QAction* opens = menu.addMenu(button->menu());
      opens->setText(button->text().isEmpty() ? button->accessibleName() : button->text());
    } else {
      menu.addAction(button->defaultAction());
    }
  }
}

}  // namespace widgets
