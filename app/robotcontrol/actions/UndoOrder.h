// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <vector>

class QUndoStack;

namespace app {

/// A common undo for everything that can be edited: it reverts the last change of the document that was
/// edited last. Each undo stack keeps its own order of changes. Stacks may be destroyed at any time. GUI
/// thread.
class UndoOrder final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Registers a stack; ignored if it is registered already.
  void add(QUndoStack* stack);
  /// Reverts a change and returns its stack; null if there is nothing to undo.
  QUndoStack* undo();
  /// Repeats a change and returns its stack; null if there is nothing to redo.
  QUndoStack* redo();

 private:
  /// Moves a stack to the front.
  void touch(QUndoStack* stack);

  /// The one that was edited last is the first.
  std::vector<QUndoStack*> stacks_;
};

}  // namespace app
