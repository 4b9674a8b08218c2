// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/EmptyHint.h"

#include <QAbstractItemView>
#include <QEvent>

namespace widgets {

EmptyHint::EmptyHint(QAbstractItemView* over) : EmptyHint(over->viewport()) {}

EmptyHint::EmptyHint(QWidget* over) : QLabel(over) {
  setObjectName(QStringLiteral("emptyHint"));
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  setMargin(16);
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
  return QLabel::eventFilter(watched, event);
}

void EmptyHint::fit() {
  setGeometry(parentWidget()->rect());
}

}  // namespace widgets
