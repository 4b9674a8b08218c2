// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace widgets {

/// The place on Qt's undo stack of a step that was done in a document which keeps its history itself, by its
/// own undo() and redo(). The document must outlive the stack. GUI thread.
template <typename Document>
class HistoryStep final : public QUndoCommand {
 public:
  /// `changed` is called when the step is pushed, undone or redone.
  HistoryStep(const QString& text, Document& document, std::function<void()> changed)
      : QUndoCommand(text), document_(document), changed_(std::move(changed)) {}
  void undo() override {
    document_.undo();
    changed_();
  }
  void redo() override {
    // QUndoStack::push() calls redo() once, when the step is done already.
    if (std::exchange(done_, true)) document_.redo();
    changed_();
  }

 private:
  Document& document_;
  std::function<void()> changed_;
  bool done_ = false;
};

}  // namespace widgets
