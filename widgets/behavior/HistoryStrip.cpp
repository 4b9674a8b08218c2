// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/HistoryStrip.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace widgets {

HistoryStrip::HistoryStrip(const OptionHistory& history, QWidget* parent)
    : QWidget(parent), history_(history) {
  setObjectName(QStringLiteral("behaviorHistory"));
  setAccessibleName(tr("States of the last minute"));
  setMinimumHeight(static_cast<int>(2 * OptionHistory::kRow));
}

QSize HistoryStrip::sizeHint() const {
  return {400, std::max(minimumHeight(), static_cast<int>(history_.height()))};
}

void HistoryStrip::refresh() {
  setMinimumHeight(std::max(static_cast<int>(2 * OptionHistory::kRow), static_cast<int>(history_.height())));
  update();
}

void HistoryStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  history_.paint(painter, rect(), palette());
}

bool HistoryStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto* segment = history_.at(help->pos(), width());
  QToolTip::showText(help->globalPos(), segment == nullptr ? QString() : OptionHistory::toolTip(*segment),
                     this);
  return true;
}

}  // namespace widgets
