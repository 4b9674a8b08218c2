// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QMargins>
#include <QString>
#include <QStringList>
#include <functional>
#include <initializer_list>
#include <optional>

#include "widgets/Theme.h"

class QAbstractItemModel;
class QAction;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QModelIndex;
class QSortFilterProxyModel;
class QScrollArea;
class QSplitter;
class QTableView;
class QToolButton;
class QTreeView;
class QVBoxLayout;
class QWidget;

// Factory functions for the controls that all views have in common: actions, buttons, tool rows, footers,
// search fields. They give every control an object name (for tests and scripts), an accessible name, and a
// tooltip that names its shortcut. All controls are children of the parent that is passed in. GUI thread.
namespace widgets {

/// The texts that identify a control.
struct ControlText {
  /// Object name. Tests and scripts find the control by it, so it never changes and is never translated.
  const char* name;
  /// Label and accessible name, translated; shown where there is room.
  QString text;
  /// A translated sentence; the shortcut is appended. May be empty.
  QString toolTip;
  /// Keyboard shortcut; empty: none.
  QKeySequence shortcut = {};
};

/// Sets the widget's object name, accessible name and tooltip.
void describe(QWidget& widget, const ControlText& text);
/// Creates an action of `owner`, named as describe() names a widget. `icon` is a name for widgets::icon().
/// The shortcut works while the focus is anywhere within `owner`.
QAction* makeAction(QWidget* owner, const char* icon, const ControlText& text);
/// Creates an action for something that is on or off; `on`: how it begins.
QAction* makeToggle(QWidget* owner, const char* icon, const ControlText& text, bool on = false);
/// Returns a flat button that triggers the action.
QToolButton* makeButton(QWidget* parent, QAction* action);
/// Returns a flat button with the action's text beside the icon.
QToolButton* makeLabeledButton(QWidget* parent, QAction* action);
/// Returns a flat button with the text that opens a menu.
QToolButton* makeMenuButton(QWidget* parent, const ControlText& text, QMenu* menu);
/// Creates a row for tools; buttons for which it has no room are offered by a button » at its end. `margin`
/// in pixels: usually that of a toolbar. Returns its layout; the row itself is the layout's parentWidget().
QHBoxLayout* makeToolRow(QWidget* parent, int margin = 2);
/// Appends a flat button for each action.
void addButtons(QHBoxLayout* row, std::initializer_list<QAction*> actions);
/// Gives a widget a layout in which its parts are stacked vertically.
QVBoxLayout* makeColumn(QWidget* widget, const QMargins& margins = {}, int spacing = 0);
/// A part of a splitter, and which share of the room it gets, compared with the others.
struct SplitterPart {
  QWidget* widget;
  int stretch = 0;
};
/// Creates a splitter. `name` is its object name.
QSplitter* makeSplitter(QWidget* parent, const char* name, Qt::Orientation orientation,
                        std::initializer_list<SplitterPart> parts);
/// Creates an area without a frame in which a content scrolls where it does not get the room that it needs:
/// in a low dock its rows would be squeezed otherwise.
QScrollArea* makeScrollArea(QWidget* parent, QWidget* content);
/// Creates a row for short texts below a picture. Returns its layout; the row itself is the layout's
/// parentWidget().
QHBoxLayout* makeFooter(QWidget* parent);
/// Appends a label to the footer. `name` is its object name, `text` its accessible name; the label starts
/// empty.
QLabel* addLabel(QHBoxLayout* footer, const char* name, const QString& text);
/// Creates a label that starts empty and wraps its lines. `name` is its object name, `text` its accessible
/// name.
QLabel* makeNote(QWidget* parent, const char* name, const QString& text);
/// Shows the label in the color of a meaning; unset: in the usual color.
void setMeaning(QLabel& label, std::optional<Meaning> meaning);
/// Shows the outcome of a request; `bad`: in the color of an error.
void showOutcome(QLabel& label, const QString& text, bool bad);
/// Creates a search field with an icon and a clear button. Escape clears it.
QLineEdit* makeSearchField(QWidget* parent, const ControlText& text);
/// Creates a search field that filters a model of rows while the user types, whatever their case.
QLineEdit* makeFilterField(QWidget* parent, const ControlText& text, QSortFilterProxyModel& filtered,
                           QAbstractItemModel& source);
/// Width in pixels that a column needs for this text, in the widget's font.
int textWidth(const QWidget& widget, const QString& text);
/// Applies the look that all trees share: alternating rows of equal height, no focus frame, no editing on a
/// single click.
void styleTree(QTreeView& tree);
/// Creates a tree with that look. `text` has no tooltip: items have theirs.
QTreeView* makeTree(QWidget* parent, const ControlText& text, QAbstractItemModel* model);
/// Creates a table with the look that all tables share: alternating rows as high as a line, which are
/// selected as a whole; no grid, no row numbers, nothing in bold. `text` has no tooltip: cells have theirs.
QTableView* makeTable(QWidget* parent, const ControlText& text, QAbstractItemModel* model);
/// Creates a table of what happens one after the other, with rows as low as possible. Tab leaves it.
QTableView* makeEventTable(QWidget* parent, const ControlText& text, QAbstractItemModel* model);
/// Unchecks `follow` when the user scrolls away from the table's end to read, and checks it again when the
/// end is reached.
void followEnd(QTableView& table, QAction& follow);
/// Returns the texts of a row's cells for copyRows().
using RowTexts = std::function<QStringList(const QModelIndex& row)>;
/// Copies the selected rows to the clipboard, in their order, a line each with tabs between the texts.
/// Without a selection the clipboard keeps what it has.
void copyRows(const QTableView& table, const RowTexts& texts);
/// The texts of the first columns of a row.
QStringList firstTexts(const QModelIndex& row, int columns);

}  // namespace widgets
