// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <vector>

class QKeyEvent;
class QWidget;

namespace app {

/// The keys with the same effect wherever the focus is, in a window or in a dock that floats beside it,
/// except in text fields: the single place that decides this. It receives keys before the focused widget and
/// before all shortcuts. Dialogs, menus and open lists keep their keys.
///
/// It also moves the focus to the contents of the window, away from toolbar widgets whose values keys would
/// change. GUI thread; it belongs to the window.
class WindowKeys final : public QObject {
  Q_OBJECT
 public:
  /// A key and its effect.
  struct Binding {
    /// A single key with its modifiers.
    QKeySequence key;
    /// The effect, for the list of shortcuts.
    QString text;
    /// If it returns false, the focused widget gets the key; empty: always true.
    std::function<bool()> applies;
    std::function<void()> run;
    /// Whether it also works in text fields.
    bool inTextFields = false;
    /// Whether it runs repeatedly while the key is held down.
    bool repeats = false;
    /// The key with which it was added.
    QKeySequence shipped = {};
  };

  /// Becomes a child of the window and starts filtering events.
  explicit WindowKeys(QWidget& window);

  /// If several bindings have the same key, the first one that applies is used.
  void add(Binding binding);
  const std::vector<Binding>& bindings() const { return bindings_; }
  /// Gives a binding another key; an empty one removes it.
  void setKey(std::size_t binding, const QKeySequence& key) { bindings_[binding].key = key; }
  /// Moves the focus to the largest view, unless a view has it. Return in a field for a number does the same,
  /// within the field's view if it is in one: the keys that follow are meant for the content.
  void focusContent();

  /// Handles key presses of the whole application, and the activation of the window.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The binding that applies; null if there is none.
  const Binding* find(const QWidget& focus, const QKeyEvent& event) const;
  /// Moves the focus from a field for a number to the content when Return has been handled there.
  void leaveField(QWidget& focus, const QKeyEvent& event);
  /// Lets Return press a focused button.
  bool pressButton(QWidget& focus, const QKeyEvent& event) const;
  /// Whether a widget is in the window or in a dock that floats beside it.
  bool ofWindow(const QWidget& widget) const;

  QWidget& window_;
  std::vector<Binding> bindings_;
};

/// Whether a widget accepts typed text.
bool isTextField(const QWidget& widget);

}  // namespace app
