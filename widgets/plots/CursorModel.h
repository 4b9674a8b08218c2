// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "robotlink/series/Statistics.h"
#include "widgets/plots/CurveModel.h"

namespace widgets {

/// A table of the values of a plot's curves at two cursors and between them: a row for each curve. GUI
/// thread.
class CursorModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kName, kFirst, kSecond, kDifference, kMin, kMax, kMean, kDeviation, kColumns };
  /// The times of the cursors in s.
  using Cursors = std::optional<std::pair<double, double>>;

  /// `curves` must outlive the model.
  explicit CursorModel(const CurveModel& curves, QObject* parent = nullptr);
  void setCursors(const Cursors& cursors);
  const Cursors& cursors() const { return cursors_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  static constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
  struct Row {
    /// The curve's title, and the text of its source.
    QString title, name;
    int color = 0;
    /// The values at the cursors.
    std::optional<double> first, second;
    /// Number of points between them; as long as it is the same, so are the points.
    std::size_t count = kUnknown;
    robotlink::Statistics between = {};
    /// The names of states at the cursors; states have no differences and no statistics.
    std::optional<std::pair<QString, QString>> states = {};
  };
  /// Recomputes the rows.
  void update();
  /// The number in a cell; empty if there is none.
  static std::optional<double> number(const Row& row, int column);

  const CurveModel& curves_;
  Cursors cursors_;
  std::vector<Row> rows_;
};

}  // namespace widgets
