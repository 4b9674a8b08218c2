// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "widgets/processes/ProcessGraph.h"

namespace robotcontrol {
class ProcessTable;
}

namespace widgets {

/// Builds the graph of a process table and lays it out. `before` is an older table, `elapsed` before `now`;
/// null: all rates are 0.
ProcessGraph processGraph(const robotcontrol::ProcessTable& now, const robotcontrol::ProcessTable* before,
                          robotlink::Duration elapsed, const ProcessGraph::Options& options);

}  // namespace widgets
