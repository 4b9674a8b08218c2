// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "app/robotcontrol/actions/Shortcuts.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace app {

/// Lists all keys, first those that work everywhere, then view by view, with a search field, and gives the
/// current one another key. It is never larger than the screen. GUI thread; the shortcuts must outlive it.
class ShortcutsDialog final : public QDialog {
  Q_OBJECT
 public:
  ShortcutsDialog(Shortcuts& shortcuts, QWidget* window);

 private:
  void createWidgets();
  void connectSignals();
  /// Builds the list; keeps the current row.
  void fill();
  /// Shows only the entries that contain a text.
  void filter(const QString& text);
  /// The current entry; null: a group, or nothing.
  const Shortcut* current() const;
  void showCurrent();
  void report(const robotlink::Result<void>& done);
  /// Limits the size to that of the screen.
  void fitScreen();

  Shortcuts& shortcuts_;
  /// The shortcuts in the list; a row has the index of its shortcut.
  std::vector<Shortcut> all_;
  QLineEdit* search_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QKeySequenceEdit* key_ = nullptr;
  QPushButton *assign_ = nullptr, *reset_ = nullptr, *resetAll_ = nullptr;
  QLabel* state_ = nullptr;
};

}  // namespace app
