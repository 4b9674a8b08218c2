// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/RobotTables.h"

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

template <typename Table>
const Table* tableOf(Session& session, const char* path) {
  return session.store().latestAs<Table>(session.selectedRobot() + "/" + path, Instant::max());
}

}  // namespace

const robotcontrol::KeyTable* keyTable(Session& session) {
  return tableOf<robotcontrol::KeyTable>(session, streams::kKeys);
}

const robotcontrol::SolutionTable* solutionTable(Session& session) {
  return tableOf<robotcontrol::SolutionTable>(session, streams::kSolutions);
}

std::vector<std::string> keyNames(Session& session) {
  std::vector<std::string> names;
  if (const auto* table = keyTable(session)) {
    for (const auto& key : table->keys()) names.push_back(key.name());
  }
  return names;
}

std::vector<std::string> taskNames(Session& session) {
  std::vector<std::string> names;
  if (const auto* table = solutionTable(session)) {
    for (const auto& task : table->tasks()) names.push_back(task.name());
  }
  return names;
}

std::vector<std::string> solutionNames(Session& session, const std::string& name) {
  std::vector<std::string> names;
  const auto* table = solutionTable(session);
  for (int i = 0; table != nullptr && i < table->tasks_size(); ++i) {
    if (table->tasks(i).name() != name) continue;
    for (const auto& solution : table->tasks(i).solutions()) names.push_back(solution.name());
  }
  return names;
}

}  // namespace robotlink
