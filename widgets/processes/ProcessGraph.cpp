// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/ProcessGraph.h"

#include <algorithm>

namespace widgets {

quint64 ProcessGraph::Node::missed() const {
  quint64 sum = 0;
  for (const Port& port : inputs) sum += port.missed;
  return sum;
}

bool ProcessGraph::Node::fallsBehind() const {
  return std::any_of(inputs.begin(), inputs.end(), [](const Port& input) { return input.falls; });
}

int ProcessGraph::find(const QString& name) const {
  const auto found =
      std::find_if(nodes.begin(), nodes.end(), [&](const Node& node) { return node.name == name; });
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

const ProcessGraph::Port& ProcessGraph::output(const Edge& edge) const {
  return nodes[static_cast<std::size_t>(edge.from)].outputs[static_cast<std::size_t>(edge.output)];
}

const ProcessGraph::Port& ProcessGraph::input(const Edge& edge) const {
  return nodes[static_cast<std::size_t>(edge.to)].inputs[static_cast<std::size_t>(edge.input)];
}

}  // namespace widgets
