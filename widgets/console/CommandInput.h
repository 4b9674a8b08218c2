// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace robotlink {
class CommandTable;
}

namespace widgets {

class CommandLog;

/// A field for a command line: Tab completes, Up and Down go through the history, Return submits. Text that
/// was typed before Up comes back with Down. GUI thread; log and commands must outlive it.
class CommandInput final : public QLineEdit {
  Q_OBJECT
 public:
  CommandInput(const robotlink::CommandTable& commands, const CommandLog& log, QWidget* parent);

 Q_SIGNALS:
  /// Return was pressed in a line that is not empty; the field is empty again.
  void submitted(const QString& line);
  /// Tab was pressed, and the word can become any of these.
  void ambiguous(const QStringList& candidates);

 protected:
  /// Takes Tab, which would move the focus.
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void complete();
  /// Shows an older (-1) or newer (1) line of the history.
  void recall(int step);

  const robotlink::CommandTable& commands_;
  const CommandLog& log_;
  /// The number of lines back in the history; 0: the typed line.
  int back_ = 0;
  QString typed_;
};

}  // namespace widgets
