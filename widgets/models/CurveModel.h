// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/models/PlotSource.h"

namespace widgets {

/// The curves of a plot: the plot's legend, with the values of the moment. Points are kept for as long as
/// `history`. Columns: curve, the newest value, its unit, and the value under the cursor. GUI thread.
class CurveModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kName, kValue, kUnit, kAtCursor, kColumns };
  static constexpr double kHistory = 300;             // s
  static constexpr std::size_t kMaxPoints = 300'000;  // of a curve

  struct Curve {
    explicit Curve(PlotSource source) : series(std::move(source)) {}
    PlotSeries series;
    int color = 0;  ///< number for curveColor()
    std::deque<PlotSeries::Point> points;
    std::size_t taken = 0;   ///< of the points, how many a canvas has
    bool restarted = false;  ///< the canvas must begin anew
    bool requested = false;  ///< its debug key was asked for
  };

  using QAbstractTableModel::QAbstractTableModel;
  /// False if it is there already.
  bool add(const PlotSource& source);
  void remove(int row);
  void clear();
  /// Takes what came; true if there is something new to draw.
  bool update(const robotlink::StreamStore& store);
  /// The time that the cursor points at; nothing: it is elsewhere.
  void setCursor(std::optional<double> time);
  std::vector<std::unique_ptr<Curve>>& curves() { return curves_; }
  const std::vector<std::unique_ptr<Curve>>& curves() const { return curves_; }
  /// All points: a column of times, then one for each curve, empty where it has no value at that time.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  int freeColor() const;
  /// The value that a curve has at the cursor: that of the last point before it.
  std::optional<double> atCursor(const Curve& curve) const;

  std::vector<std::unique_ptr<Curve>> curves_;
  std::optional<double> cursor_;
};

}  // namespace widgets
