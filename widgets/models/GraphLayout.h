// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/ProcessGraph.h"

namespace widgets {

/// Sizes of the picture, in pixels at zoom 1.
struct GraphSizes {
  static constexpr double kNodeWidth = 220;
  static constexpr double kHeader = 40;
  static constexpr double kRow = 18;
  static constexpr double kColumnGap = 76;
  static constexpr double kRowGap = 28;
};

/// Puts a graph in layers from left to right, after Sugiyama: edges that close a cycle are turned, each node
/// lies right of all that it receives from, and within a layer nodes lie near the middle of their senders.
/// Depends on nothing but the graph, so that it does not move between tables.
void layOut(ProcessGraph& graph);

}  // namespace widgets
