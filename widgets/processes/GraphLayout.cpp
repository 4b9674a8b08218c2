// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/GraphLayout.h"

#include <algorithm>
#include <map>

namespace widgets {
namespace {

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// Whether a path of the kept edges leads from one node to another.
bool reaches(const ProcessGraph& graph, const std::vector<int>& kept, int from, int to) {
  std::vector<bool> seen(graph.nodes.size(), false);
  std::vector<int> open{from};
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    if (node == to) return true;
    if (seen[at(node)]) continue;
    seen[at(node)] = true;
    for (const int index : kept) {
      if (graph.edges[at(index)].from == node) open.push_back(graph.edges[at(index)].to);
    }
  }
  return false;
}

/// Marks the edges that would close a cycle as `back`. Blocking edges are kept first, then those in the order
/// of the layout; edges to the platform (a node without tasks) come last, so that data flow from the sensors
/// on the left to the actuators on the right.
void turnCycles(ProcessGraph& graph) {
  std::vector<int> order(graph.edges.size()), kept;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto rank = [&](int index) {
    const auto& edge = graph.edges[at(index)];
    if (graph.nodes[at(edge.to)].tasks.isEmpty()) return 3;
    return graph.input(edge).blocking ? 0 : edge.from < edge.to ? 1 : 2;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
  for (const int index : order) {
    auto& edge = graph.edges[at(index)];
    edge.back = reaches(graph, kept, edge.to, edge.from);
    if (!edge.back) kept.push_back(index);
  }
}

void assignLayers(ProcessGraph& graph) {
  for (std::size_t round = 0; round < graph.nodes.size(); ++round) {
    bool moved = false;
    for (const auto& edge : graph.edges) {
      if (edge.back) continue;
      const int wanted = graph.nodes[at(edge.from)].layer + 1;
      int& layer = graph.nodes[at(edge.to)].layer;
      if (layer < wanted) {
        layer = wanted;
        moved = true;
      }
    }
    if (!moved) return;
  }
}

using Layers = std::map<int, std::vector<int>>;

Layers orderedLayers(const ProcessGraph& graph) {
  Layers layers;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    layers[graph.nodes[i].layer].push_back(static_cast<int>(i));
  std::vector<double> place(graph.nodes.size());
  for (auto& [layer, nodes] : layers) {
    const auto middle = [&](int node) {
      double sum = 0, count = 0;
      for (const auto& edge : graph.edges) {
        if (edge.to != node || edge.back) continue;
        sum += place[at(edge.from)];
        ++count;
      }
      return count > 0 ? sum / count : 0;
    };
    std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) { return middle(a) < middle(b); });
    const double half = static_cast<double>(nodes.size()) / 2;
    for (std::size_t i = 0; i < nodes.size(); ++i) place[at(nodes[i])] = static_cast<double>(i) - half;
  }
  return layers;
}

double heightOf(const ProcessGraph::Node& node) {
  const auto rows = static_cast<double>(node.inputs.size() + node.outputs.size());
  return GraphSizes::kHeader + rows * GraphSizes::kRow + 6;
}

void placeNode(ProcessGraph::Node& node, double x, double y) {
  node.rect = QRectF(x, y, GraphSizes::kNodeWidth, heightOf(node));
  double row = y + GraphSizes::kHeader;
  const auto place = [&](ProcessGraph::Port& port) {
    port.rect = QRectF(x, row, GraphSizes::kNodeWidth, GraphSizes::kRow);
    row += GraphSizes::kRow;
  };
  std::for_each(node.inputs.begin(), node.inputs.end(), place);
  std::for_each(node.outputs.begin(), node.outputs.end(), place);
}

}  // namespace

void layOut(ProcessGraph& graph) {
  turnCycles(graph);
  assignLayers(graph);
  bool back = false;
  for (const auto& edge : graph.edges) back = back || edge.back;
  for (const auto& [layer, nodes] : orderedLayers(graph)) {
    double height = -GraphSizes::kRowGap;
    for (const int node : nodes) height += heightOf(graph.nodes[at(node)]) + GraphSizes::kRowGap;
    double y = -height / 2;
    for (const int node : nodes) {
      placeNode(graph.nodes[at(node)], layer * (GraphSizes::kNodeWidth + GraphSizes::kColumnGap), y);
      y += heightOf(graph.nodes[at(node)]) + GraphSizes::kRowGap;
    }
  }
  for (const auto& node : graph.nodes) graph.bounds |= node.rect;
  const double side = back ? GraphSizes::kColumnGap / 2 : 0;
  if (!graph.nodes.empty()) graph.bounds.adjust(-side - 12, -12, side + 12, back ? 48 : 12);
}

}  // namespace widgets
