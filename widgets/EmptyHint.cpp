// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/EmptyHint.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>
#include <QToolTip>

namespace widgets {
namespace {

constexpr int kHintMargin = 16, kMinHintMargin = 4;  // pixels
constexpr int kHintFlags = Qt::AlignCenter | Qt::TextWordWrap;

}  // namespace

EmptyHint::EmptyHint(QAbstractItemView* over) : EmptyHint(over->viewport()) {}

EmptyHint::EmptyHint(QWidget* over) : QLabel(over) {
  setObjectName(QStringLiteral("emptyHint"));
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  setEnabled(false);  // gray, as the style paints disabled texts
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  over->installEventFilter(this);
  hide();
  fit();
}

void EmptyHint::setHint(const QString& text) {
  if (this->text() != text) setText(text);
  setVisible(!text.isEmpty());
}

bool EmptyHint::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fit();
  if (event->type() == QEvent::ToolTip && isVisible() && shownText() != text()) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), parentWidget());
    return true;
  }
  return QLabel::eventFilter(watched, event);
}

QRect EmptyHint::room() const {
  const QRect wide = rect().adjusted(kHintMargin, kHintMargin, -kHintMargin, -kHintMargin);
  return fits(text(), wide)
             ? wide
             : rect().adjusted(kMinHintMargin, kMinHintMargin, -kMinHintMargin, -kMinHintMargin);
}

bool EmptyHint::fits(const QString& text, const QRect& place) const {
  const QRect endless(0, 0, place.width(), QWIDGETSIZE_MAX);
  const QRect needed = fontMetrics().boundingRect(endless, kHintFlags, text);
  return needed.width() <= place.width() && needed.height() <= place.height();
}

QString EmptyHint::shownText() const {
  const QRect place = room();
  QString shown = text();
  while (!shown.isEmpty() && !fits(shown, place)) {
    const int end = shown.lastIndexOf(QRegularExpression(QStringLiteral("\\s+\\S")));
    if (end <= 0) return QStringLiteral("…");
    shown = shown.left(end) + QStringLiteral("…");
  }
  return shown;
}

void EmptyHint::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, room(), kHintFlags, palette(), isEnabled(), shownText(), foregroundRole());
}

void EmptyHint::fit() {
  setGeometry(parentWidget()->rect());
}

}  // namespace widgets
