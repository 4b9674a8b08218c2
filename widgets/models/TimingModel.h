// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class StopwatchTimes;
}

namespace widgets {

/// How long the tasks of a robot's processes took, by process, task and solution, since the last reset. Times
/// are real ones in milliseconds, rates refer to the platform's clock, the share is that of the process's
/// whole frames ("frame" is the row of these). add() collects; update() shows it, once a tick. GUI thread.
class TimingModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kProcess, kTask, kSolution, kLast, kMean, kMinimum, kMaximum, kRate, kShare, kColumns };
  static constexpr int kNumberRole = Qt::UserRole + 1;  ///< to sort by; a text's is the text

  using QAbstractTableModel::QAbstractTableModel;
  void add(const std::string& process, robotlink::Instant time, const robotcontrol::StopwatchTimes& times);
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
    robotlink::Instant first, latest;
  };
  Row& rowFor(const std::string& process, const std::string& task, const std::string& solution);
  double number(const Row& row, int column) const;
  double frameSum(const std::string& process) const;

  std::vector<Row> rows_;
  int shown_ = 0;  // rows that views know of
};

}  // namespace widgets
