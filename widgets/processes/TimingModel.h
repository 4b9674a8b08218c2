// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class ProcessTable;
class StopwatchTimes;
}  // namespace robotcontrol

#include "widgets/TitledModel.h"

namespace widgets {

/// Run times of the tasks of a robot's processes since the last reset, by process, task and solution. Times
/// are real time in milliseconds. Rates are frames per second on the platform's clock over the last two
/// seconds. The share is that of a task's mean time in its process's period; the row "frame" stands for whole
/// frames, and at 100 % the process cannot keep its rate in real time. A solution that no longer runs has
/// neither rate nor share. add() collects; update() announces the changes once per tick. GUI thread.
class TimingModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Times in ms, kRate in Hz, kShare as a share of 1.
  enum Column { kProcess, kTask, kSolution, kLast, kMean, kMinimum, kMax, kRate, kShare, kColumns };
  /// The number of a cell, for sorting; the text in columns of texts.
  static constexpr int kNumberRole = Qt::UserRole + 1;

  explicit TimingModel(QObject* parent = nullptr);
  /// Adds the times of one frame. `frame` is its number; 0: unknown, then it is counted.
  void add(const std::string& process, std::uint64_t frame, robotlink::Instant time,
           const robotcontrol::StopwatchTimes& times);
  /// Removes processes and tasks that are not in the table.
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
    std::uint64_t count = 0;
    double sum = 0, minimum = 0, maximum = 0, last = 0;  ///< s
    /// Time of the last frame in which it ran.
    robotlink::Instant latest;
  };
  /// Time and number of a frame.
  struct Frames {
    struct Frame {
      robotlink::Instant time;
      std::uint64_t number;
    };
    std::deque<Frame> recent;
    void add(Frame frame);
    /// Hz, from the frames' numbers, so that missing frames do not matter; 0 if it is not known yet.
    double rate() const;
  };
  Row& rowFor(const std::string& process, const std::string& task, const std::string& solution);
  /// The number of a cell, in the column's unit.
  double number(const Row& row, int column) const;
  /// Rate of the row's process if the solution ran in its newest frame, else 0.
  double rateOf(const Row& row) const;

  std::vector<Row> rows_;
  /// By process.
  std::map<std::string, Frames> frames_;
  /// Number of rows that views know of.
  int shown_ = 0;
};

}  // namespace widgets
