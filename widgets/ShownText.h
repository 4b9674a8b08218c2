// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

class QWidget;

namespace widgets {

/// The rows of the largest table or tree that a view shows, as CSV after RFC 4180 with the titles first: its
/// columns from left to right without hidden ones, and the rows that can be reached by scrolling, so that
/// those of folded branches are left out. In a tree the first column is indented by two spaces a level.
/// Unset if there is neither. GUI thread.
std::optional<QString> shownTable(const QWidget& view);

/// The same table with tabs between the columns. Unset if there is none.
std::optional<QString> shownNumbers(const QWidget& view);

/// A row for each value that a view shows outside of tables: texts, boxes and sliders with a name, and tabs
/// between name and value. Unset if there is none.
std::optional<QString> shownValues(const QWidget& view);

/// A table that is made line by line, with tabs between the columns and the titles first.
class TabTable {
 public:
  explicit TabTable(const QStringList& titles) { add(titles); }
  /// Tabs and line breaks in a cell become spaces.
  void add(QStringList cells);
  const QString& text() const { return text_; }

 private:
  QString text_;
};

/// A table as CSV with tabs instead of commas, and without quotes; tabs and line breaks in cells become
/// spaces.
QString tabsOfCsv(const QString& csv);

/// A table with tabs between the columns as CSV after RFC 4180.
QString csvOfTabs(const QString& table);

/// The text of the largest text that a view shows, such as a console's; else its table with tabs between the
/// columns. Unset if there is neither.
std::optional<QString> shownText(const QWidget& view);

}  // namespace widgets
