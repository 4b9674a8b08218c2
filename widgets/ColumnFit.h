// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <vector>

class QAbstractItemView;
class QHeaderView;
class QTableView;
class QTreeView;

namespace widgets {

/// What a column holds, which decides how much room it gets.
enum class ColumnKind : std::uint8_t {
  kName,    ///< is what a row is found by: whole before anything else
  kNumber,  ///< short: its contents are whole, its title is cut first
  kText,    ///< any length: takes what the others leave, and is cut
};

/// What a column needs, in pixels.
struct ColumnNeed {
  ColumnKind kind = ColumnKind::kName;
  int title = 0;     ///< width of its header
  int contents = 0;  ///< width of its widest cell; not used for kText
  int pinned = 0;    ///< what a person set; 0: nothing
};

/// The widths of columns that share `room` pixels. They fill it; they are wider together only where the names
/// and the contents of numbers need it, so that the table has to be scrolled. A single name takes at most
/// three quarters of the room. Pure.
std::vector<int> fittedWidths(const std::vector<ColumnNeed>& columns, int room);

/// Keeps the columns of a table or tree fitted while its size and contents change. Columns that a person
/// resized keep their width; a double click on the edge of one fits it again. Belongs to the header of its
/// view. GUI thread.
class ColumnFit final : public QObject {
  Q_OBJECT
 public:
  /// The view has its model already; `kinds` has one entry a column.
  ColumnFit(QTableView& table, std::vector<ColumnKind> kinds);
  ColumnFit(QTreeView& tree, std::vector<ColumnKind> kinds);

  /// The ColumnFit of a header; null if it has none.
  static ColumnFit* of(const QHeaderView& header);

  /// The width that the user gave the column; 0: none.
  int pinned(int column) const { return needs_[static_cast<std::size_t>(column)].pinned; }
  /// 0: it is fitted again.
  void pin(int column, int width);
  /// The column gets room for this text, whatever it holds: for what is chosen in it.
  void expect(int column, const QString& text);
  /// Fits the columns now; does nothing while the view is not visible.
  void fit();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  ColumnFit(QAbstractItemView& view, QHeaderView& header, std::vector<ColumnKind> kinds);
  void followModel();
  void schedule();
  void measure();

  QAbstractItemView& view_;
  QHeaderView& header_;
  std::vector<ColumnNeed> needs_;
  std::vector<QString> expected_;  // of each column
  QTimer later_;
  QElapsedTimer sinceFit_;
  bool fitting_ = false;
};

}  // namespace widgets
