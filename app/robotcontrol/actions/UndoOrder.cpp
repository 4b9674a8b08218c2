// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/UndoOrder.h"

#include <QUndoStack>
#include <algorithm>

namespace app {

void UndoOrder::add(QUndoStack* stack) {
  if (std::ranges::find(stacks_, stack) != stacks_.end()) return;
  stacks_.push_back(stack);
  if (stack->index() > 0) touch(stack);
  connect(stack, &QUndoStack::indexChanged, this, [this, stack] { touch(stack); });
  connect(stack, &QObject::destroyed, this, [this, stack] { std::erase(stacks_, stack); });
}

void UndoOrder::touch(QUndoStack* stack) {
  const auto found = std::ranges::find(stacks_, stack);
  if (found != stacks_.end() && stack->count() > 0) std::rotate(stacks_.begin(), found, found + 1);
}

QUndoStack* UndoOrder::undo() {
  const auto found = std::ranges::find_if(stacks_, &QUndoStack::canUndo);
  if (found == stacks_.end()) return nullptr;
  QUndoStack* stack = *found;
  stack->undo();
  return stack;
}

QUndoStack* UndoOrder::redo() {
  const auto found = std::ranges::find_if(stacks_, &QUndoStack::canRedo);
  if (found == stacks_.end()) return nullptr;
  QUndoStack* stack = *found;
  stack->redo();
  return stack;
}

}  // namespace app
