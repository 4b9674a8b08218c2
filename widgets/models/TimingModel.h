// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class ProcessTable;
class StopwatchTimes;
}  // namespace robotcontrol

namespace widgets {

/// How long the tasks of a robot's processes took, by process, task and solution, since the last reset. Times
/// are real ones in milliseconds, rates refer to the platform's clock over the last two seconds, the share is
/// that of the time from one frame to the next ("frame" is the row of whole frames): at 100 % the process
/// cannot keep its rate in real time. A solution that does not run any more has neither rate nor share. add()
/// collects; update() shows it, once a tick. GUI thread.
class TimingModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kProcess, kTask, kSolution, kLast, kMean, kMinimum, kMaximum, kRate, kShare, kColumns };
  static constexpr int kNumberRole = Qt::UserRole + 1;  ///< to sort by; a text's is the text

  using QAbstractTableModel::QAbstractTableModel;
  /// `frame`: its number, or 0 if it is not known.
  void add(const std::string& process, std::uint64_t frame, robotlink::Instant time,
           const robotcontrol::StopwatchTimes& times);
  /// Forgets processes and tasks that the program does not have any more.
  void keepOnly(const robotcontrol::ProcessTable& program);
  void update();
  void reset();
  /// All cells with a header, separated by commas; numbers in milliseconds and hertz.
  QString csv() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::string process, task, solution;
    std::uint64_t count = 0;
    double sum = 0, minimum = 0, maximum = 0, last = 0;  // s
    robotlink::Instant latest;
  };
  /// The frames of a process in the last seconds.
  struct Frames {
    struct Frame {
      robotlink::Instant time;
      std::uint64_t number;
    };
    std::deque<Frame> recent;
    void add(Frame frame);
    double rate() const;  ///< Hz; 0 if it is not known yet
  };
  Row& rowFor(const std::string& process, const std::string& task, const std::string& solution);
  double number(const Row& row, int column) const;
  /// Of its process, while its solution runs.
  double rateOf(const Row& row) const;

  std::vector<Row> rows_;
  std::map<std::string, Frames> frames_;  // by process
  int shown_ = 0;                         // rows that views know of
};

}  // namespace widgets
