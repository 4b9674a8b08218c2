// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <utility>
#include <vector>

class QCPCurve;
class QCPItemTracer;
class QCustomPlot;

namespace widgets {

class CurveModel;

/// Draws those curves of a CurveModel that are over another one as paths: what one source is, over what the
/// other one was at the same time (the last value before). The point at the shown instant is marked. The
/// wheel zooms, dragging pans, a double click fits. GUI thread.
class PathCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// If a path has more points, only every n-th of them is drawn.
  static constexpr std::size_t kMaxPoints = 20'000;

  /// `curves` must outlive the canvas.
  explicit PathCanvas(CurveModel& curves, QWidget* parent = nullptr);
  /// Draws the paths between two times, and marks where they are at `shown`; in s. Shows all of them until
  /// the user zooms or pans.
  void refresh(double from, double to, double shown);
  /// Shows all of the paths, and what comes.
  void fit();
  /// Whether a unit has the same length on both axes.
  void setEqual(bool on);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void applyTheme();
  /// Makes the graphs match the paths of the model.
  void matchPaths();
  void fitPaths();

  CurveModel& curves_;
  QCustomPlot* plot_;
  struct Path {
    QCPCurve* graph = nullptr;
    /// A ring at the shown instant.
    QCPItemTracer* mark = nullptr;
    /// The points that were drawn: their numbers, and their times.
    std::pair<std::size_t, std::size_t> points;
    std::pair<double, double> times;
  };
  std::vector<Path> paths_;
  bool isFitted_ = true;
  bool isEqual_ = false;
};

}  // namespace widgets
