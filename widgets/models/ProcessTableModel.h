// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "widgets/models/ProcessGraph.h"

namespace widgets {

/// The processes of a graph as a table, with what the picture has no room for. GUI thread.
class ProcessTableModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kName, kState, kRate, kFrames, kPeriod, kPriority, kMissed, kDropped, kTasks, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// Keeps the rows as long as the processes are the same.
  void setGraph(const ProcessGraph& graph);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<ProcessGraph::Node> rows_;
};

}  // namespace widgets
