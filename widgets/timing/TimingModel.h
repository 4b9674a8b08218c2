// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "widgets/TitledModel.h"
#include "widgets/timing/FrameRate.h"
#include "widgets/timing/PeriodStatistics.h"
#include "widgets/timing/TimeStatistics.h"

namespace robotcontrol {
class ProcessTable;
class StopwatchTimes;
}  // namespace robotcontrol

namespace widgets {

/// Run times of the tasks of a robot's processes since the last reset, by process, task and solution. Times
/// are real time in milliseconds. Rates are frames per second on the platform's clock over the last two
/// seconds. The share is that of a task's mean time in its process's period; the row "frame" stands for whole
/// frames, and at 100 % the process cannot keep its rate in real time. A solution that no longer runs has
/// neither rate nor share. Its jitter is how much the periods differ: the times on the platform's clock from
/// one frame in which it ran to the next. Where frames between them were not published there is no period.
///
/// An overrun is a frame that took longer than its period (FrameRate::period()). It counts for the row
/// "frame" of its process, and for the solution that took longest in it, which is where to look first.
/// add() collects; update() announces the changes once per tick. GUI thread.
class TimingModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Times and periods in ms, kRate in Hz, kShare as a share of 1; kMedian, kNinetyFive and kNinetyNine: the
  /// time that 50, 95 and 99 % of all do not exceed.
  enum Column {
    kProcess,
    kTask,
    kSolution,
    kLast,
    kMean,
    kMinimum,
    kMedian,
    kNinetyFive,
    kNinetyNine,
    kMax,
    kRate,
    kPeriodMinimum,
    kPeriodMax,
    kJitter,
    kOverruns,
    kShare,
    kColumns
  };
  /// The number of a cell, for sorting; the text in columns of texts.
  static constexpr int kNumberRole = Qt::UserRole + 1;

  explicit TimingModel(QObject* parent = nullptr);
  /// Adds the times of one frame. `frame` is its number; 0: unknown, then it is counted.
  void add(const std::string& process, std::uint64_t frame, robotlink::Instant time,
           const robotcontrol::StopwatchTimes& times);
  /// Takes the periods of the processes, and removes processes and tasks that are not in the table.
  void keepOnly(const robotcontrol::ProcessTable& program);
  /// Announces new rows and changed numbers to the views.
  void update();
  /// Clears all statistics.
  void reset();
  /// All cells with a header, separated by commas; milliseconds, hertz and shares of 1.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// Statistics of one solution; an empty task stands for whole frames.
  struct Row {
    std::string process, task, solution;
    TimeStatistics times;
    std::uint64_t overruns = 0;
    /// From one frame to the next.
    PeriodStatistics periods;
    /// Time and number of the last frame in which it ran.
    robotlink::Instant latest;
    std::uint64_t latestFrame = 0;
  };
  Row& rowFor(const std::string& process, const std::string& task, const std::string& solution);
  /// Notes that a solution ran in the newest frame of its process, at this time.
  void addRun(Row& row, robotlink::Instant time);
  /// Counts an overrun if the frame was one.
  void countOverrun(const std::string& process, const robotcontrol::StopwatchTimes& times);
  /// The number of a cell, in the column's unit.
  double number(const Row& row, int column) const;
  /// Rate of the row's process if the solution ran in its newest frame, else 0.
  double rateOf(const Row& row) const;
  QString shownText(const Row& row, int column) const;

  std::vector<Row> rows_;
  /// Keyed by process.
  std::map<std::string, FrameRate> frames_;
  /// The periods of processes in s; 0: it has none.
  std::map<std::string, double> periods_;
  /// Number of rows that views know of.
  int shown_ = 0;
};

}  // namespace widgets
