// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/text/FindBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextBlock>
#include <QToolButton>

#include "widgets/Controls.h"

namespace widgets {

FindBar::FindBar(QPlainTextEdit& edit, QWidget* parent) : QWidget(parent), edit_(edit) {
  setObjectName(QStringLiteral("findBar"));
  createFields();
  hide();
}

void FindBar::createFields() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  sought_ = new QLineEdit(this);
  describe(*sought_,
           {"findText", tr("Find"), tr("Enter finds the next match, Shift+Enter the previous one")});
  sought_->setPlaceholderText(tr("Find"));
  instead_ = new QLineEdit(this);
  describe(*instead_, {"replaceText", tr("Replace by"), tr("Replacement text")});
  instead_->setPlaceholderText(tr("Replace by"));
  QAction* exact = makeToggle(this, "labels", {"findCase", tr("Match case"), tr("Match case")});
  QAction* before = makeAction(this, "up", {"findBefore", tr("Previous"), tr("Finds the previous match")});
  QAction* next =
      makeAction(this, "down", {"findNext", tr("Next"), tr("Finds the next match"), QKeySequence::FindNext});
  QAction* one = makeAction(this, "edit",
                            {"replaceOne", tr("Replace"), tr("Replaces this match and finds the next one")});
  QAction* all = makeAction(this, "check-all",
                            {"replaceAll", tr("Replace all"), tr("Replaces all matches, as one undo step")});
  row->addWidget(sought_, 2);
  exactCase_ = makeButton(this, exact);
  row->addWidget(exactCase_);
  addButtons(row, {before, next});
  row->addWidget(instead_, 2);
  row->addWidget(makeLabeledButton(this, one));
  row->addWidget(makeLabeledButton(this, all));
  outcome_ = new QLabel(this);
  describe(*outcome_, {"findOutcome", tr("What was found"), {}});
  row->addWidget(outcome_, 1);
  connect(before, &QAction::triggered, this, [this] { find(true); });
  connect(next, &QAction::triggered, this, [this] { find(false); });
  connect(one, &QAction::triggered, this, &FindBar::replace);
  connect(all, &QAction::triggered, this, &FindBar::replaceAll);
}

void FindBar::open() {
  const QString selected = edit_.textCursor().selectedText();
  if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) sought_->setText(selected);
  outcome_->clear();
  show();
  sought_->setFocus();
  sought_->selectAll();
}

QTextDocument::FindFlags FindBar::flags() const {
  return exactCase_->isChecked() ? QTextDocument::FindFlags(QTextDocument::FindCaseSensitively)
                                 : QTextDocument::FindFlags();
}

void FindBar::report(const QString& text, bool bad) {
  showOutcome(*outcome_, text, bad);
}

bool FindBar::find(bool backwards) {
  const QString sought = sought_->text();
  if (sought.isEmpty()) return false;
  QTextDocument::FindFlags how = flags();
  if (backwards) how |= QTextDocument::FindBackward;
  QTextCursor found = edit_.document()->find(sought, edit_.textCursor(), how);
  bool wrapped = false;
  if (found.isNull()) {
    QTextCursor end(edit_.document());
    if (backwards) end.movePosition(QTextCursor::End);
    found = edit_.document()->find(sought, end, how);
    wrapped = true;
  }
  if (found.isNull()) {
    report(tr("Not found"), true);
    return false;
  }
  edit_.setTextCursor(found);
  edit_.centerCursor();
  report(wrapped ? tr("Continued from the other end") : QString(), false);
  return true;
}

void FindBar::replace() {
  QTextCursor cursor = edit_.textCursor();
  const auto sensitivity = exactCase_->isChecked() ? Qt::CaseSensitive : Qt::CaseInsensitive;
  if (cursor.hasSelection() && cursor.selectedText().compare(sought_->text(), sensitivity) == 0) {
    cursor.insertText(instead_->text());
    edit_.setTextCursor(cursor);
  }
  find(false);
}

int FindBar::replaceAll() {
  const QString sought = sought_->text();
  if (sought.isEmpty()) return 0;
  int count = 0;
  QTextCursor history(edit_.document());
  history.beginEditBlock();
  QTextCursor found = edit_.document()->find(sought, 0, flags());
  while (!found.isNull()) {
    found.insertText(instead_->text());
    ++count;
    found = edit_.document()->find(sought, found.position(), flags());
  }
  history.endEditBlock();
  report(count == 0 ? tr("Not found") : tr("Replaced: %1").arg(count), count == 0);
  return count;
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    find(event->modifiers().testFlag(Qt::ShiftModifier));
  } else if (event->key() == Qt::Key_Escape) {
    hide();
    edit_.setFocus();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace widgets
