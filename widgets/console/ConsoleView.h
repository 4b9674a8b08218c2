// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/console/CommandLog.h"

class QAction;
class QLabel;
class QPlainTextEdit;

namespace widgets {

class CommandInput;
class EmptyHint;

/// A line for commands, with completion and history, above it what was run and what came of it: commands that
/// were typed here and in the palette, and what was refused later. All consoles show the same; the number of
/// lines is bounded.
///
/// Registered as "console". GUI thread.
class ConsoleView final : public View {
  Q_OBJECT
 public:
  explicit ConsoleView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override {}

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Appends an entry in its color; the output keeps its place if its end is not in view.
  void append(const CommandLog::Entry& entry);
  /// Shows all entries again, also after a change of the colors.
  void showAll();
  void changeEvent(QEvent* event) override;
  /// Shows what the typed command takes.
  void showHint();

  CommandLog& log_;
  QPlainTextEdit* output_ = nullptr;
  CommandInput* input_ = nullptr;
  QLabel* hint_ = nullptr;
  EmptyHint* empty_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* clear_ = nullptr;
};

}  // namespace widgets
