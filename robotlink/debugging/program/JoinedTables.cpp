// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/JoinedTables.h"

#include "robotlink/debugging/SharedDebugQueue.h"

namespace robotlink {
namespace {

using robotcontrol::KeyTable;

void join(KeyTable::Key& to, const KeyTable::Key& from) {
  to.set_in_use(to.in_use() || from.in_use());
  if (to.mode().kind() == robotcontrol::KeyMode::OFF) *to.mutable_mode() = from.mode();
  to.mutable_solutions()->MergeFrom(from.solutions());
}

}  // namespace

void JoinedTables::notice(const SharedDebugQueue& queue) {
  for (const SharedDebugMessage& message : queue.messages) {
    if (const auto* keys = message.as<KeyTable>()) {
      keys_[queue.process] = *keys;
      keysChanged_ = true;
    } else if (const auto* solutions = message.as<robotcontrol::SolutionTable>()) {
      solutions_[queue.process] = *solutions;
      solutionsChanged_ = true;
    }
  }
}

void JoinedTables::fillKeys(KeyTable& to) const {
  std::map<std::string, KeyTable::Key> joined;
  for (const auto& [process, table] : keys_) {
    for (const KeyTable::Key& key : table.keys()) {
      const auto [entry, isFirst] = joined.emplace(key.name(), key);
      if (!isFirst) join(entry->second, key);
    }
  }
  for (auto& [name, key] : joined) *to.add_keys() = std::move(key);
}

void JoinedTables::fillSolutions(const std::vector<std::string>& processes,
                                 robotcontrol::SolutionTable& to) const {
  for (const std::string& process : processes) {
    const auto found = solutions_.find(process);
    if (found != solutions_.end()) to.mutable_tasks()->MergeFrom(found->second.tasks());
  }
}

}  // namespace robotlink
