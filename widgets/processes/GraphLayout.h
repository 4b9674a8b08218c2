// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/processes/ProcessGraph.h"

namespace widgets {

/// Sizes of the picture of a ProcessGraph, in pixels at zoom 1.
struct GraphSizes {
  static constexpr double kNodeWidth = 220;
  /// Height of a node's title.
  static constexpr double kHeader = 40;
  /// Height of a port.
  static constexpr double kRow = 18;
  /// Horizontal distance between layers.
  static constexpr double kColumnGap = 76;
  /// Vertical distance between the nodes of a layer.
  static constexpr double kRowGap = 28;
};

/// Assigns layers, rectangles and bounds. A layered drawing from left to right after K. Sugiyama et al.,
/// "Methods for visual understanding of hierarchical system structures" (1981): edges that close a cycle are
/// marked as `back`, each node is to the right of all its senders, and within a layer nodes are ordered by
/// the mean position of their senders. The result depends on the graph only, so nodes do not jump from one
/// table to the next.
void layOut(ProcessGraph& graph);

}  // namespace widgets
