// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/RobotTables.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

template <typename Table>
const Table* tableOf(Session& session, const char* path) {
  return session.store().latestAs<Table>(session.selectedRobot() + "/" + path, Instant::max());
}

/// The packages of all ends of processes that match.
template <typename Matches>
std::set<std::string> portsOf(const StreamStore& store, const std::string& robot, Instant time,
                              Matches matches) {
  std::set<std::string> packages;
  const auto* table = store.latestAs<robotcontrol::ProcessTable>(robot + "/" + streams::kProcesses, time);
  for (int i = 0; table != nullptr && i < table->processes_size(); ++i) {
    for (const auto* ports : {&table->processes(i).receivers(), &table->processes(i).senders()}) {
      for (const auto& port : *ports) {
        if (!port.package().starts_with("debug/") && matches(port)) packages.insert(port.package());
      }
    }
  }
  return packages;
}

}  // namespace

const robotcontrol::KeyTable* keyTable(Session& session) {
  return tableOf<robotcontrol::KeyTable>(session, streams::kKeys);
}

const robotcontrol::SolutionTable* solutionTable(Session& session) {
  return tableOf<robotcontrol::SolutionTable>(session, streams::kSolutions);
}

bool areTasksKnown(Session& session) {
  const auto* processes = tableOf<robotcontrol::ProcessTable>(session, streams::kProcesses);
  if (processes == nullptr || processes->processes().empty()) return false;
  const auto* status =
      session.store().latestAs<robotcontrol::SimulationStatus>(streams::kSimulation, Instant::max());
  const bool isPaused = status == nullptr || !status->running();
  const std::vector<std::string> known = taskNames(session);
  return std::ranges::all_of(processes->processes(), [&](const auto& process) {
    if (!process.state().starts_with("running") || process.tasks().empty()) return true;
    return (isPaused || process.frames() > 0) &&
           std::ranges::all_of(process.tasks(), [&](const std::string& task) {
             return std::ranges::find(known, task) != known.end();
           });
  });
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

std::set<std::string> programPackages(const StreamStore& store, const std::string& robot, Instant time) {
  return portsOf(store, robot, time, [](const auto&) { return true; });
}

std::set<std::string> heldPackages(const StreamStore& store, const std::string& robot, Instant time) {
  return portsOf(store, robot, time, [](const auto& port) { return port.held(); });
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

std::string activeSolution(const StreamStore& store, const std::string& robot, const std::string& task) {
  const auto* table =
      store.latestAs<robotcontrol::SolutionTable>(robot + "/" + streams::kSolutions, Instant::max());
  if (table == nullptr) return {};
  const auto found = std::ranges::find(table->tasks(), task, [](const auto& one) { return one.name(); });
  return found == table->tasks().end() ? std::string() : found->active();
}

}  // namespace robotlink
