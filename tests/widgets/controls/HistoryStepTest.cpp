// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/HistoryStep.h"

#include <QTest>
#include <QUndoStack>

#include "tests/widgets/GuiTest.h"

namespace widgets::test {

/// A document's steps on Qt's undo stack.
class HistoryStepTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStepIsDoneAlreadyWhenItIsPushed() {
    push();
    QCOMPARE(document_.redone, 0);
    QCOMPARE(changes_, 1);
    QCOMPARE(stack_.undoText(), QStringLiteral("stroke"));
  }

  void theDocumentGoesBackAndForth() {
    push();
    stack_.undo();
    QCOMPARE(document_.undone, 1);
    stack_.redo();
    QCOMPARE(document_.redone, 1);
    QCOMPARE(changes_, 3);
  }

  void cleanup() {
    stack_.clear();
    document_ = {};
    changes_ = 0;
  }

 private:
  struct CountedDocument {
    int undone = 0, redone = 0;
    void undo() { ++undone; }
    void redo() { ++redone; }
  };

  void push() {
    stack_.push(new HistoryStep(QStringLiteral("stroke"), document_, [this] { ++changes_; }));
  }

  CountedDocument document_;
  QUndoStack stack_;
  int changes_ = 0;
};

const GuiTest<HistoryStepTest> kHistoryStepTest;

}  // namespace widgets::test

#include "HistoryStepTest.moc"
