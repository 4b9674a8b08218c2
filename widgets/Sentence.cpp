// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Sentence.h"

#include <QPainter>
#include <QWidget>
#include <algorithm>

namespace widgets {

void paintSentence(QPainter& painter, const QWidget& widget, const QString& text, SentencePlace place) {
  const QFontMetricsF metrics(painter.font());
  const QRectF room(0, 0, std::max(80, widget.width() - 60), widget.height());
  QRectF box = metrics.boundingRect(room, Qt::TextWordWrap, text).adjusted(-12, -6, 12, 6);
  const QPointF top(widget.width() / 2.0, box.height() / 2 + 8);
  box.moveCenter(place == SentencePlace::kTop ? top : QRectF(widget.rect()).center());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(widget.palette().color(QPalette::ToolTipBase));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(widget.palette().color(QPalette::ToolTipText));
  painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
  painter.restore();
}

}  // namespace widgets
