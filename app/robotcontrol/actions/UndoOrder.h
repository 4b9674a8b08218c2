// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

class QUndoStack;

namespace app {

/// A common undo for everything that can be edited: it reverts the last change of the document that was
/// edited last. Each history, such as an undo stack, keeps its own order of changes. Histories may be
/// destroyed at any time. GUI thread.
class UndoOrder final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// A history that is no undo stack.
  struct History {
    const QObject* owner = nullptr;
    std::function<bool()> canUndo, canRedo;
    std::function<void()> undo, redo;
  };

  /// Registers a stack; ignored if it is registered already.
  void add(QUndoStack* stack);
  /// Registers another history; touch() says when it has changed.
  void add(History history);
  /// The history of an owner was edited last.
  void touch(const QObject* owner);
  /// Reverts a change and returns the owner of its history; null if there is nothing to undo.
  const QObject* undo();
  /// Repeats a change and returns the owner of its history; null if there is nothing to redo.
  const QObject* redo();

 private:
  const QObject* revert(std::function<bool()> History::*can, std::function<void()> History::*act);

  /// The one that was edited last is the first.
  std::vector<History> histories_;
};

}  // namespace app
