// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <vector>

class QKeyEvent;
class QWidget;

namespace app {

/// The keys that mean the same wherever the focus is in a window or in a dock that floats beside it, but for
/// text fields: the one place that decides this. It looks at keys before the widget that has the focus, and
/// before all shortcuts. Dialogs, menus and lists that have popped up keep their keys.
///
/// It also sees to it that the focus is in what the window shows, and not in a box of a toolbar that keys
/// would change. GUI thread; it belongs to the window.
class WindowKeys final : public QObject {
  Q_OBJECT
 public:
  struct Binding {
    QKeySequence key;               ///< one key with its modifiers
    QString text;                   ///< what it does, for the list of keys
    std::function<bool()> applies;  ///< false: the key belongs to whoever has the focus
    std::function<void()> run;
    bool inTextFields = false;  ///< no text is edited by it
    bool repeats = false;       ///< runs again and again while the key is held
  };

  explicit WindowKeys(QWidget& window);

  void add(Binding binding);
  const std::vector<Binding>& bindings() const { return bindings_; }
  /// Gives the focus to the largest view, if no view has it.
  void focusContent();

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  const Binding* find(const QWidget& focus, const QKeyEvent& event) const;
  bool pressButton(QWidget& focus, const QKeyEvent& event) const;
  bool ofWindow(const QWidget& widget) const;

  QWidget& window_;
  std::vector<Binding> bindings_;
};

/// Whether somebody types text there.
bool isTextField(const QWidget& widget);

}  // namespace app
