// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHBoxLayout>
#include <QString>
#include <QStringList>
#include <vector>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"

class QLabel;
class QPushButton;
class QTreeWidget;

// The parts that dialogs about remote robots have in common. All are children of the parent that is passed
// in. GUI thread.
namespace app {

/// A column of a list.
struct ListColumn {
  QString title;
  widgets::ColumnKind kind = widgets::ColumnKind::kName;
  /// A text for which there is always room; empty: none.
  QString widest = {};
};

/// Creates a list that is at least `lines` rows high.
QTreeWidget* makeList(QWidget* parent, const widgets::ControlText& text,
                      const std::vector<ListColumn>& columns, int lines);
/// Removes rows at the end of a list, or appends empty ones.
void setRowCount(QTreeWidget& list, int count);
/// Creates a button; `text` is what it says, with '&' before its key. `icon` is a name for widgets::icon(),
/// null for none.
QPushButton* makePushButton(QWidget* parent, const widgets::ControlText& text, const char* icon = nullptr);
/// Appends a label whose key goes to the widget, and the widget.
void addLabeled(QHBoxLayout* row, const QString& label, QWidget* widget);
/// Creates a label for the state of the dialog's work, with room for `lines` lines.
QLabel* makeState(QWidget* parent, const char* name, int lines);
/// Hides a widget for which the dialog keeps its place.
void hideInPlace(QWidget& widget);

}  // namespace app
