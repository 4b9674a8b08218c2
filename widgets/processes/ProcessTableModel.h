// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/processes/ProcessGraph.h"

#include "widgets/RowModel.h"

namespace widgets {

/// The processes of a ProcessGraph as a table, with figures for which the picture has no room. GUI thread.
class ProcessTableModel final : public RowModel<ProcessGraph::Node> {
  Q_OBJECT
 public:
  /// Rate in Hz, period in ms, priority as nice value; kMissed counts packages, kDropped debug messages.
  enum Column { kName, kState, kRate, kFrames, kPeriod, kPriority, kMissed, kDropped, kTasks, kColumns };

  explicit ProcessTableModel(QObject* parent = nullptr);
  /// Rows, and so the selection, are kept if the processes are the same.
  void setGraph(const ProcessGraph& graph);
  QVariant data(const QModelIndex& index, int role) const override;
};

}  // namespace widgets
