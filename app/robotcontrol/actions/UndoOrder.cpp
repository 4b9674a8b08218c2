// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/UndoOrder.h"

#include <QUndoStack>
#include <algorithm>
#include <utility>

namespace app {

void UndoOrder::add(QUndoStack* stack) {
  if (std::ranges::find(histories_, stack, &History::owner) != histories_.end()) return;
  add({stack, [stack] { return stack->canUndo(); }, [stack] { return stack->canRedo(); },
       [stack] { stack->undo(); }, [stack] { stack->redo(); }});
  if (stack->index() > 0) touch(stack);
  connect(stack, &QUndoStack::indexChanged, this, [this, stack] {
    if (stack->count() > 0) touch(stack);
  });
}

void UndoOrder::add(History history) {
  const QObject* owner = history.owner;
  histories_.push_back(std::move(history));
  connect(owner, &QObject::destroyed, this, [this, owner] {
    std::erase_if(histories_, [&](const History& one) { return one.owner == owner; });
  });
}

void UndoOrder::touch(const QObject* owner) {
  const auto found = std::ranges::find(histories_, owner, &History::owner);
  if (found != histories_.end()) std::rotate(histories_.begin(), found, found + 1);
}

const QObject* UndoOrder::undo() {
  return revert(&History::canUndo, &History::undo);
}

const QObject* UndoOrder::redo() {
  return revert(&History::canRedo, &History::redo);
}

const QObject* UndoOrder::revert(std::function<bool()> History::*can, std::function<void()> History::*act) {
  const auto found = std::ranges::find_if(histories_, [&](const History& one) { return (one.*can)(); });
  if (found == histories_.end()) return nullptr;
  // Copies, since the change may move the history to the front.
  const History history = *found;
  (history.*act)();
  return history.owner;
}

}  // namespace app
