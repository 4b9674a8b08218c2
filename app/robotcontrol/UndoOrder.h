// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <vector>

class QUndoStack;

namespace app {

/// One undo for all that can be edited: it takes back the last change of what was edited last. Stacks that
/// are added keep their own order of changes; they may go at any time. GUI thread.
class UndoOrder final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Nothing happens if it was added before.
  void add(QUndoStack* stack);
  /// Whose change was taken back; null if there is nothing to take back.
  QUndoStack* undo();
  /// Whose change was made again; null if there is none.
  QUndoStack* redo();

 private:
  void touch(QUndoStack* stack);

  std::vector<QUndoStack*> stacks_;  ///< what was edited last comes first
};

}  // namespace app
