// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ProcessTables.h"

#include "robotlink/base/Utf8.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::ProcessTable;

constexpr int kMaxNodes = 500;
constexpr std::size_t kMaxLinks = 10'000;

/// The rows of a table by the ids of their nodes.
class ProcessRows {
 public:
  /// Null: there are too many.
  ProcessTable::Process* of(const std::string& node) {
    const auto known = rows_.find(node);
    if (known != rows_.end()) return known->second;
    if (table.processes_size() >= kMaxNodes) return nullptr;
    ProcessTable::Process* row = table.add_processes();
    row->set_name(validUtf8(node));
    return rows_[node] = row;
  }

  ProcessTable table;

 private:
  std::map<std::string, ProcessTable::Process*> rows_;
};

}  // namespace

ConnectionGraph graphOf(const std::string& robot, const ProcessTable& table) {
  ConnectionGraph graph;
  for (const auto& process : table.processes()) {
    const std::string id = robot + "/" + process.name();
    for (const auto& port : process.senders())
      graph.publishedTopics[robot + "/" + port.package()].push_back(id);
    for (const auto& port : process.receivers())
      graph.subscribedTopics[robot + "/" + port.package()].push_back(id);
  }
  return graph;
}

ProcessTable tableOf(const ConnectionGraph& graph, const std::map<std::string, std::string>& types) {
  ProcessRows rows;
  const auto fill = [&](ProcessTable::Port& port, const std::string& topic) {
    port.set_package(validUtf8(topic));
    if (const auto type = types.find(topic); type != types.end()) port.set_type(validUtf8(type->second));
  };
  for (const auto& [topic, nodes] : graph.publishedTopics) {
    for (const std::string& node : nodes)
      if (auto* row = rows.of(node)) fill(*row->add_senders(), topic);
  }
  std::size_t links = 0;
  for (const auto& [topic, nodes] : graph.subscribedTopics) {
    const auto senders = graph.publishedTopics.find(topic);
    for (const std::string& node : nodes) {
      auto* row = rows.of(node);
      if (row == nullptr) continue;
      if (senders == graph.publishedTopics.end()) {
        fill(*row->add_receivers(), topic);
        continue;
      }
      for (const std::string& sender : senders->second) {
        if (++links > kMaxLinks) break;
        fill(*row->add_receivers(), topic);
        row->mutable_receivers()->rbegin()->set_peer(validUtf8(sender));
      }
    }
  }
  return std::move(rows.table);
}

}  // namespace robotlink::websocket
