// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "widgets/TypedStreams.h"
#include "widgets/View.h"
#include "widgets/timing/LatencyModel.h"
#include "widgets/timing/LatencyTrace.h"
#include "widgets/timing/TimingModel.h"

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QSplitter;
class QTabWidget;
class QTableView;

namespace widgets {

class EmptyHint;
class GanttCanvas;
class OpenLogs;

/// Run times of the selected robot's processes: a Gantt chart of the last seconds, statistics of each task,
/// and how long readings such as images take to become commands. Measuring costs the robot some time, so it
/// is on only while the button "Measure" is checked, which sets the debug key "timing/tasks". When another
/// robot is selected while the button is checked, the view requests the key for that robot and clears the
/// statistics.
///
/// The statistics are those of all frames since the last reset; the chart is that of the instant that the
/// timeline shows. Registered as "timing". GUI thread.
class TimingView final : public View {
  Q_OBJECT
 public:
  explicit TimingView(ViewContext& context, QWidget* parent = nullptr);
  /// Adds the StopwatchTimes that arrived since the last tick.
  void tick() override;

 protected:
  /// In a low and wide view, the tables are next to the chart instead of below it.
  void resizeEvent(QResizeEvent* event) override;

 private:
  void createActions();
  void createTables();
  QWidget* createLatency();
  void createViews();
  void connectSignals();
  /// Starts over when another robot is selected.
  void followRobot();
  /// Takes the periods of the robot's processes; removes the rows of processes and tasks that its layout no
  /// longer has. True if the layout changed.
  bool followProgram();
  /// Reads what arrived; false if nothing did.
  bool takeNews();
  /// Requests the debug key on or off.
  void measure(bool on);
  void reset();
  void copy();
  void showState();

  OpenLogs& logs_;
  TimingModel model_;
  LatencyModel latencies_;
  LatencyTrace trace_;
  /// The models sorted by their numbers.
  QSortFilterProxyModel* sorted_;
  QSortFilterProxyModel* sortedLatencies_;
  GanttCanvas* chart_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  QTableView* table_ = nullptr;
  QTableView* latencyTable_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  EmptyHint* chartHint_ = nullptr;
  EmptyHint* latencyHint_ = nullptr;
  QAction* measure_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* zoomIn_ = nullptr;
  QAction* zoomOut_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* copy_ = nullptr;
  /// The part of each stream that was already read, by path.
  std::map<std::string, StreamCursor> cursors_;
  std::string robot_;
  /// Processes with their tasks and periods as one string, to detect another layout; and the periods by
  /// process, s.
  std::string program_;
  std::map<std::string, double> periods_;
  /// The reason why the robot does not measure; empty: it does, or was not asked.
  QString refusal_;
};

}  // namespace widgets
