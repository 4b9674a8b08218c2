// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/TableGraph.h"

#include <algorithm>
#include <limits>

#include "robotcontrol/Debugging.pb.h"
#include "widgets/processes/GraphLayout.h"

namespace widgets {
namespace {

using robotcontrol::ProcessTable;

const ProcessTable::Process* findProcess(const ProcessTable* table, const std::string& name) {
  if (table == nullptr) return nullptr;
  const auto& all = table->processes();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& process) { return process.name() == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Rate of a counter that only grows. If it is smaller than before, counting has started over, and the rate
/// is 0.
double rateOf(std::uint64_t now, std::uint64_t before, robotlink::Duration elapsed) {
  const double seconds = robotlink::seconds(elapsed);
  return seconds > 0 && now >= before ? static_cast<double>(now - before) / seconds : 0;
}

template <typename Ports>
const ProcessTable::Port* findPort(const Ports* ports, const ProcessTable::Port& like) {
  if (ports == nullptr) return nullptr;
  const auto found = std::find_if(ports->begin(), ports->end(), [&](const auto& port) {
    return port.package() == like.package() && port.peer() == like.peer();
  });
  return found == ports->end() ? nullptr : &*found;
}

template <typename Ports>
std::vector<ProcessGraph::Port> portsOf(const Ports& now, const Ports* before, robotlink::Duration elapsed,
                                        const ProcessGraph::Options& options) {
  std::vector<ProcessGraph::Port> ports;
  for (const auto& from : now) {
    if (!options.debugLinks && from.package().starts_with("debug/")) continue;
    ProcessGraph::Port& port = ports.emplace_back();
    port.package = QString::fromStdString(from.package());
    port.type = QString::fromStdString(from.type());
    port.peer = QString::fromStdString(from.peer());
    port.blocking = from.blocking();
    port.count = from.count();
    port.missed = from.missed();
    port.held = from.held();
    if (const auto* old = findPort(before, from)) {
      port.rate = rateOf(from.count(), old->count(), elapsed);
      port.missedRate = rateOf(from.missed(), old->missed(), elapsed);
    }
  }
  return ports;
}

/// Rate of packages sent to an input, read or missed, in Hz.
double offeredRate(const ProcessGraph::Port& input) {
  return input.rate + input.missedRate;
}

/// Sets `falls` at the inputs of which a process is meant to read every package and does not.
void findFalling(ProcessGraph::Node& node) {
  constexpr double kTolerance = 0.98;
  double meant = node.period > 0 ? 1 / node.period : std::numeric_limits<double>::infinity();
  for (const auto& input : node.inputs) {
    if (input.blocking && offeredRate(input) > 0) meant = std::min(meant, offeredRate(input));
  }
  for (auto& input : node.inputs) {
    input.falls = input.blocking && input.missedRate > 0 && meant >= kTolerance * offeredRate(input);
  }
}

ProcessGraph::Node nodeOf(const ProcessTable::Process& from, const ProcessTable::Process* before,
                          robotlink::Duration elapsed, const ProcessGraph::Options& options) {
  ProcessGraph::Node node;
  node.name = QString::fromStdString(from.name());
  node.state = QString::fromStdString(from.state());
  node.failed = from.state().starts_with("failed");
  node.frames = from.frames();
  node.rate = before != nullptr ? rateOf(from.frames(), before->frames(), elapsed) : 0;
  node.period = from.period();
  node.priority = from.priority();
  node.dropped = from.dropped();
  for (const std::string& task : from.tasks()) node.tasks << QString::fromStdString(task);
  node.inputs =
      portsOf(from.receivers(), before != nullptr ? &before->receivers() : nullptr, elapsed, options);
  node.outputs = portsOf(from.senders(), before != nullptr ? &before->senders() : nullptr, elapsed, options);
  findFalling(node);
  return node;
}

/// Index of the node's output for the package of an input; added if no table describes it.
int outputOf(ProcessGraph::Node& node, const ProcessGraph::Port& input) {
  for (std::size_t i = 0; i < node.outputs.size(); ++i) {
    if (node.outputs[i].package == input.package) return static_cast<int>(i);
  }
  ProcessGraph::Port port = input;
  port.peer.clear();
  port.blocking = false;
  port.missed = 0;
  port.missedRate = 0;
  port.falls = false;
  port.held = false;
  node.outputs.push_back(port);
  return static_cast<int>(node.outputs.size()) - 1;
}

void connectPorts(ProcessGraph& graph) {
  const auto known = graph.nodes.size();
  for (std::size_t to = 0; to < known; ++to) {
    for (std::size_t input = 0; input < graph.nodes[to].inputs.size(); ++input) {
      const ProcessGraph::Port port = graph.nodes[to].inputs[input];
      if (port.peer.isEmpty()) continue;
      int from = graph.find(port.peer);
      if (from < 0) {  // a platform, which no table describes
        from = static_cast<int>(graph.nodes.size());
        graph.nodes.emplace_back().name = port.peer;
      }
      const int output = outputOf(graph.nodes[static_cast<std::size_t>(from)], port);
      graph.edges.push_back({from, output, static_cast<int>(to), static_cast<int>(input), false});
    }
  }
}

}  // namespace

ProcessGraph processGraph(const ProcessTable& now, const ProcessTable* before, robotlink::Duration elapsed,
                          const ProcessGraph::Options& options) {
  ProcessGraph graph;
  for (const auto& process : now.processes()) {
    graph.nodes.push_back(nodeOf(process, findProcess(before, process.name()), elapsed, options));
  }
  connectPorts(graph);
  layOut(graph);
  return graph;
}

}  // namespace widgets
