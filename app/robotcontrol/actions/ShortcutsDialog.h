// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <vector>

class QTreeWidget;

namespace app {

class WindowKeys;

/// A key and its effect.
struct Shortcut {
  QKeySequence key;
  QString text;
  /// Title of the view in which it works; empty: everywhere.
  QString view;
  /// The action or shortcut; null for a binding of WindowKeys.
  const QObject* owner = nullptr;
};

/// All keys of a window and of the views that are open in it.
std::vector<Shortcut> shortcutsOf(const QWidget& window, const WindowKeys& keys);

/// Lists all keys, first those that work everywhere, then view by view, with a search field. It is never
/// larger than the screen. GUI thread.
class ShortcutsDialog final : public QDialog {
  Q_OBJECT
 public:
  ShortcutsDialog(const WindowKeys& keys, QWidget* window);

 private:
  /// Builds the list.
  void fill(const std::vector<Shortcut>& shortcuts);
  /// Shows only the entries that contain a text.
  void filter(const QString& text);
  /// Limits the size to that of the screen.
  void fitScreen();

  QTreeWidget* list_ = nullptr;
};

}  // namespace app
