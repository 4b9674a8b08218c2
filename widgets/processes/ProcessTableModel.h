// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "widgets/processes/ProcessGraph.h"

namespace widgets {

/// The processes of a ProcessGraph as a table, with figures for which the picture has no room. GUI thread.
class ProcessTableModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// Rate in Hz, period in ms, priority as nice value; kMissed counts packages, kDropped debug messages.
  enum Column { kName, kState, kRate, kFrames, kPeriod, kPriority, kMissed, kDropped, kTasks, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// Rows, and so the selection, are kept if the processes are the same.
  void setGraph(const ProcessGraph& graph);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<ProcessGraph::Node> rows_;
};

}  // namespace widgets
