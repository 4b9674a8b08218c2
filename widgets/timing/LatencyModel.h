// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "widgets/TitledModel.h"
#include "widgets/timing/LatencyTrace.h"
#include "widgets/timing/TimeStatistics.h"

namespace widgets {

/// The times in which a robot's readings became commands since the last reset, a row for each reading and
/// command; milliseconds. add() collects; update() announces the changes once per tick. GUI thread.
class LatencyModel final : public TitledModel {
  Q_OBJECT
 public:
  /// kWaiting and kComputing are the means of the two parts of a latency; see Latency.
  enum Column {
    kReading,
    kCommand,
    kLast,
    kMean,
    kMedian,
    kNinetyFive,
    kNinetyNine,
    kMax,
    kWaiting,
    kComputing,
    kCount,
    kColumns
  };
  /// The number of a cell, for sorting; the text in columns of texts.
  static constexpr int kNumberRole = Qt::UserRole + 1;

  explicit LatencyModel(QObject* parent = nullptr);
  void add(const Latency& latency);
  /// Announces new rows and changed numbers to the views.
  void update();
  /// Clears all statistics.
  void reset();
  /// All cells with a header, separated by commas; milliseconds.
  QString csv() const;
  /// "camera/image to joints/request: 21.4 ms, 95 %: 30.2 ms", of the first reading that is an image, else of
  /// the first row; empty without rows.
  QString summary() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::string reading, command;
    TimeStatistics total, waiting, computing;
  };
  double number(const Row& row, int column) const;

  std::vector<Row> rows_;
  /// Number of rows that views know of.
  int shown_ = 0;
};

}  // namespace widgets
