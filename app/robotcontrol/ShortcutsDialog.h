// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <vector>

class QTreeWidget;

namespace app {

class WindowKeys;

/// One key and what it does.
struct Shortcut {
  QKeySequence key;
  QString text;
  QString view;                    ///< title of the view in which it works; empty: everywhere
  const QObject* owner = nullptr;  ///< the action or shortcut; null for those of WindowKeys
};

/// All keys of a window and of the views that are open in it.
std::vector<Shortcut> shortcutsOf(const QWidget& window, const WindowKeys& keys);

/// Lists them, first those that work everywhere, then view by view, with a field to search in. No larger than
/// the screen.
class ShortcutsDialog final : public QDialog {
  Q_OBJECT
 public:
  ShortcutsDialog(const WindowKeys& keys, QWidget* window);

 private:
  void fill(const std::vector<Shortcut>& shortcuts);
  void filter(const QString& text);
  void fitScreen();

  QTreeWidget* list_ = nullptr;
};

}  // namespace app
