// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <initializer_list>

class QAction;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QTreeView;
class QWidget;

namespace widgets {

// The controls that views have in common, made in one way: each with an object name for tests and scripts, an
// accessible name and a tool tip that names its key. All of them belong to the parent given.

/// How a control of a view is named and reached. `name` is the object name; it never changes.
struct ControlText {
  const char* name;
  QString text;     ///< spoken and, where there is room, shown
  QString toolTip;  ///< one sentence; the shortcut is added
  QKeySequence shortcut = {};
};

void describe(QWidget& widget, const ControlText& text);
/// Names the action as describe() names a widget; its shortcut works wherever the focus is within `owner`.
QAction* makeAction(QWidget* owner, const char* icon, const ControlText& text);
/// A flat button that does what the action does.
QToolButton* makeButton(QWidget* parent, QAction* action);
/// A row of tools above a picture, as tight as a toolbar: its layout, whose parentWidget() it is.
QHBoxLayout* makeToolRow(QWidget* parent);
/// Buttons that do what the actions do, at the row's end.
void addButtons(QHBoxLayout* row, std::initializer_list<QAction*> actions);
/// A row of short texts below a picture: its layout, whose parentWidget() it is.
QHBoxLayout* makeFooter(QWidget* parent);
/// A text at the footer's end that says what `text` names.
QLabel* addLabel(QHBoxLayout* footer, const char* name, const QString& text);
/// A search field with its icon and a clear button. Escape clears it.
QLineEdit* makeSearchField(QWidget* parent, const ControlText& text);
/// How wide a column must be to show this text, in the widget's font.
int textWidth(const QWidget& widget, const QString& text);
/// What all trees of this program look like: even rows, no focus frame, no edit on a mere click.
void styleTree(QTreeView& tree);

}  // namespace widgets
