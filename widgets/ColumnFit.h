// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <optional>
#include <vector>

class QAbstractItemView;
class QHeaderView;
class QTableView;
class QTreeView;

namespace widgets {

/// The kind of a column's contents, which determines its width.
enum class ColumnKind : std::uint8_t {
  /// Identifies a row: shown whole before anything else.
  kName,
  /// Short: the contents are shown whole; the title is cut first.
  kNumber,
  /// The same, but told apart by its title, such as that of a joint: both are shown whole.
  kTitledNumber,
  /// A text of any length: gets the room that the others leave, and is cut.
  kText,
};

/// The room that a column needs, in pixels.
struct ColumnNeed {
  ColumnKind kind = ColumnKind::kName;
  /// Width of the title.
  int title = 0;
  /// Width of the widest cell; not used for kText.
  int contents = 0;
  /// The width that the user chose; 0 if none.
  int pinned = 0;
};

/// Returns the widths of columns that share `room` pixels. Together they fill it. They exceed it, so that the
/// table must be scrolled, only if names, titled numbers and the contents of numbers need more. A single name
/// gets at most three quarters of the room. Numbers alone do not fill it: they are as wide as they need. A
/// pure function.
std::vector<int> fittedWidths(const std::vector<ColumnNeed>& columns, int room);

/// Keeps the columns of a table or tree fitted while its size and contents change. Columns that the user has
/// resized keep their width, until a double click on their edge fits them again. Owned by the header of its
/// view. GUI thread.
class ColumnFit final : public QObject {
  Q_OBJECT
 public:
  /// The view must already have its model; `kinds` has one entry for each column.
  ColumnFit(QTableView& table, std::vector<ColumnKind> kinds);
  ColumnFit(QTreeView& tree, std::vector<ColumnKind> kinds);
  /// For a table whose number of columns changes; all of them are of one kind. Whenever it changes, the
  /// widths that the user chose are forgotten.
  ColumnFit(QTableView& table, ColumnKind all);

  /// The ColumnFit of a header; null if it has none.
  static ColumnFit* of(const QHeaderView& header);

  /// The width that the user gave the column; 0: none.
  int pinned(int column) const;
  /// Sets the width of a column as if the user had done so; 0 fits it again.
  void pin(int column, int width);
  /// Makes room for a text even while no cell has it, such as a value that can be chosen.
  void expect(int column, const QString& text);
  /// Fits the columns now; does nothing while the view is not visible.
  void fit();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  ColumnFit(QAbstractItemView& view, QHeaderView& header, std::vector<ColumnKind> kinds);
  /// Connects the changes of the model.
  void followModel();
  /// Sets the number of needs_ to that of the columns, if it may change.
  void countColumns();
  /// Fits the columns soon, but not too often.
  void schedule();
  /// Updates the needs. Contents do not become narrower while there are rows, so that changing numbers do not
  /// make columns waver.
  void measure();

  QAbstractItemView& view_;
  QHeaderView& header_;
  std::vector<ColumnNeed> needs_;
  /// The kind of all columns; unset: their number and kinds are fixed.
  std::optional<ColumnKind> all_;
  /// The text of expect() for each column.
  std::vector<QString> expected_;
  /// For schedule().
  QTimer later_;
  /// Started by each fit().
  QElapsedTimer sinceFit_;
  /// Whether the columns are being resized here and not by the user.
  bool fitting_ = false;
};

}  // namespace widgets
