// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/console/CommandInput.h"

#include <QKeyEvent>
#include <algorithm>

#include "widgets/console/CommandLog.h"
#include "widgets/console/CommandTyping.h"

namespace widgets {

CommandInput::CommandInput(const robotlink::CommandTable& commands, const CommandLog& log, QWidget* parent)
    : QLineEdit(parent), commands_(commands), log_(log) {
  connect(this, &QLineEdit::textEdited, this, [this] { back_ = 0; });
  connect(this, &QLineEdit::returnPressed, this, [this] {
    const QString line = text().trimmed();
    if (line.isEmpty()) return;
    clear();
    back_ = 0;
    Q_EMIT submitted(line);
  });
}

bool CommandInput::event(QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() == Qt::Key_Tab && key.modifiers() == Qt::NoModifier && !text().isEmpty()) {
      complete();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void CommandInput::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Up) return recall(-1);
  if (event->key() == Qt::Key_Down) return recall(1);
  QLineEdit::keyPressEvent(event);
}

void CommandInput::complete() {
  const TypedLine before{text(), cursorPosition()};
  const TypedLine after = completed(commands_, before);
  if (after.line == before.line) {
    const QStringList candidates = typedCommand(commands_, before.line, before.cursor).candidates;
    if (candidates.size() > 1) Q_EMIT ambiguous(candidates);
    return;
  }
  setText(after.line);
  setCursorPosition(after.cursor);
}

void CommandInput::recall(int step) {
  const QStringList& history = log_.history();
  const int back = std::clamp(back_ - step, 0, history.size());
  if (back == back_) return;
  if (back_ == 0) typed_ = text();
  back_ = back;
  setText(back == 0 ? typed_ : history.at(history.size() - back));
}

}  // namespace widgets
