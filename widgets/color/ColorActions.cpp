// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorActions.h"

#include <QAction>
#include <QCoreApplication>
#include <QShortcut>

#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/color/ColorBench.h"

namespace widgets {
namespace {

struct ColorActionText {
  Q_DECLARE_TR_FUNCTIONS(widgets::ColorActions)
};

QShortcut* addShortcut(QWidget& view, const QKeySequence& key) {
  auto* shortcut = new QShortcut(key, &view);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  return shortcut;
}

}  // namespace

QString strokesText(std::size_t count) {
  return counted(count, ColorActionText::tr("1 stroke"), ColorActionText::tr("%1 strokes"));
}

ColorActions addColorActions(QWidget& view, const char* prefix, ColorBench& bench) {
  const QByteArray undoName = QByteArray(prefix) + "Undo", redoName = QByteArray(prefix) + "Redo";
  QUndoStack& stack = bench.undoStack();
  ColorActions actions{
      makeAction(&view, "undo",
                 {undoName.constData(), ColorActionText::tr("Undo"),
                  ColorActionText::tr("Undoes the last change of the samples"), QKeySequence::Undo}),
      makeAction(
          &view, "redo",
          {redoName.constData(), ColorActionText::tr("Redo"), ColorActionText::tr("Redoes what was undone"),
           QKeySequence(ColorActionText::tr("Ctrl+Shift+Z"))})};
  QObject::connect(actions.undo, &QAction::triggered, &stack, &QUndoStack::undo);
  QObject::connect(actions.redo, &QAction::triggered, &stack, &QUndoStack::redo);
  QObject::connect(&stack, &QUndoStack::canUndoChanged, actions.undo, &QAction::setEnabled);
  QObject::connect(&stack, &QUndoStack::canRedoChanged, actions.redo, &QAction::setEnabled);
  actions.undo->setEnabled(stack.canUndo());
  actions.redo->setEnabled(stack.canRedo());
  for (int digit = 0; digit <= 9; ++digit) {
    auto* shortcut = addShortcut(view, QKeySequence(Qt::Key_0 + digit));
    QObject::connect(shortcut, &QShortcut::activated, &bench,
                     [&bench, digit] { bench.setCurrentClass(digit); });
  }
  QObject::connect(addShortcut(view, QKeySequence(Qt::Key_N)), &QShortcut::activated, &bench,
                   [&bench] { bench.setMustNotBe(!bench.mustNotBe()); });
  return actions;
}

}  // namespace widgets
