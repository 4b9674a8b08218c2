// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

class QPainter;

namespace widgets {

/// The values of a list as columns, and the limits of their axis.
struct ColumnGraph {
  std::vector<double> values;
  double low = 0, high = 1;
  QString unit;

  /// Sets the limits of the axis to 0 and all values, rounded up to a number with one digit, but not beyond
  /// those of the sensor, if it has some. Values that are not finite count as none.
  void fit(double minimum, double maximum);
};

/// Keeps the axis of values that change steady: its limits become wider at once, but narrower only when the
/// values of some seconds would fit.
class SteadyLimits {
 public:
  /// For how many graphs the limits stay at least: three seconds of ticks.
  static constexpr int kPatience = 90;

  /// Sets the limits of the next graph of the same values.
  void apply(ColumnGraph& graph);

 private:
  struct Limits {
    double low, high;
    void include(const Limits& other);
  };
  /// Unset: before the first graph.
  std::optional<Limits> shown_;
  /// The limits that the graphs since the last setting would have had; unset: there was no graph.
  std::optional<Limits> wanted_;
  int count_ = 0;
};

/// Paints the columns into a rectangle of this size at the painter's origin, with the axis at the left.
/// Values that are not finite have no column. Pure.
void paintColumns(QPainter& painter, const QSize& size, const ColumnGraph& graph, const QPalette& palette,
                  std::optional<int> marked = {});

/// Shows a column graph; a tooltip has the value under the cursor. GUI thread.
class ColumnsCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ColumnsCanvas(QWidget* parent = nullptr);
  void show(ColumnGraph graph);
  const ColumnGraph& graph() const { return graph_; }
  /// The index of the column at a place; unset if there is none.
  std::optional<int> columnAt(const QPoint& at) const;
  QSize sizeHint() const override { return {400, 240}; }

 Q_SIGNALS:
  /// The cursor is over a column; -1: over none.
  void pointedAt(int column);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  /// Left and right choose the column that is marked.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void mark(std::optional<int> column);

  ColumnGraph graph_;
  std::optional<int> marked_;
};

}  // namespace widgets
