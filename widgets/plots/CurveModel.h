// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/plots/PlotSource.h"

namespace widgets {

/// The curves of a plot with their points: the data of a PlotCanvas and the rows of the plot's legend. Points
/// older than kHistory, and beyond kMaxPoints, are dropped. Times are seconds on the session's timeline. GUI
/// thread.
class CurveModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// Source, newest value, its unit, and the value under the cursor.
  enum Column { kName, kValue, kUnit, kAtCursor, kColumns };
  /// Length of the history in s, counted back from a curve's newest point.
  static constexpr double kHistory = 300;
  /// Upper bound of the points of one curve.
  static constexpr std::size_t kMaxPoints = 300'000;

  /// One curve; the canvas keeps its own copy of the points.
  struct Curve {
    explicit Curve(PlotSource source) : series(std::move(source)) {}
    /// Reads the values from the session's store.
    PlotSeries series;
    /// Index for curveColor(); the lowest that was free.
    int color = 0;
    /// Oldest first.
    std::deque<PlotSeries::Point> points;
    /// Number of points, from the front, that the canvas has copied.
    std::size_t taken = 0;
    /// The clock went back: the canvas must drop its copy.
    bool restarted = false;
    /// The debug key of the source was requested.
    bool requested = false;
  };

  using QAbstractTableModel::QAbstractTableModel;
  /// Appends a curve. False if there is one of this source already, or the source has no stream.
  bool add(const PlotSource& source);
  void remove(int row);
  void clear();
  /// Appends the points that arrived since the last call. True if there is something new to draw.
  bool update(const robotlink::StreamStore& store);
  /// Time under the cursor in s; empty: the cursor is not over the plot.
  void setCursor(std::optional<double> time);
  /// The curves, in the order of the rows. The canvas updates `taken` and `restarted`.
  std::vector<std::unique_ptr<Curve>>& curves() { return curves_; }
  const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
  /// All points as text: a column "time_s", then one per curve, empty where it has no value at that time.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// The lowest color index that no curve has.
  int freeColor() const;
  /// The value of the last point not later than the cursor; empty without one.
  std::optional<double> atCursor(const Curve& curve) const;

  std::vector<std::unique_ptr<Curve>> curves_;
  std::optional<double> cursor_;  ///< s; empty: the cursor is not over the plot
};

}  // namespace widgets
