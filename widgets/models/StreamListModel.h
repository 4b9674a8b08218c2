// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <set>
#include <string>
#include <vector>

namespace widgets {

struct LogOverview;

/// The streams of all open logs as a table. The check of a row says whether it has a row in the time line.
/// GUI thread.
class StreamListModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kPath, kCount, kBytes, kRate, kSchema, kLog, kColumns };
  static constexpr int kSortRole = Qt::UserRole + 1;    ///< numbers as numbers
  static constexpr int kFilterRole = Qt::UserRole + 2;  ///< path and schema

  struct Row {
    std::string log;  ///< its path
    std::string path, type;
    std::uint64_t count = 0, bytes = 0;
    double rate = 0;  ///< Hz
    bool shown = true;
    bool stepped = false;
    bool operator==(const Row&) const = default;
  };

  using QAbstractTableModel::QAbstractTableModel;
  /// Rows that stay the same stream keep their place, so that a selection does.
  void setRows(std::vector<Row> rows);
  const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
  static std::vector<Row> rowsOf(const std::string& log, const LogOverview& overview,
                                 const std::set<std::string>& hidden);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void shownChanged(const std::string& log, const std::string& stream, bool shown);

 private:
  std::vector<Row> rows_;
};

/// "1.4 MB"
QString bytesText(std::uint64_t bytes);

}  // namespace widgets
