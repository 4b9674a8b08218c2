// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LayoutIndex.h"

#include <algorithm>

#include "robotlink/base/TextParts.h"
#include "robotlink/packages/PackageTitles.h"

namespace robotlink {

LayoutIndex::LayoutIndex(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform)
    : layout_(layout), platform_(platform) {
  for (const Layout::Process& process : layout.processes) {
    for (std::size_t i = 0; i < process.tasks.size(); ++i) {
      const TaskCatalog::Task* task = catalog.find(process.tasks[i].task);
      if (task == nullptr || placeOf(process.tasks[i].task) != nullptr) continue;
      places_.push_back({&process, &process.tasks[i], task, i});
      for (const std::string& output : outputsOf(*task)) producers_.emplace(output, places_.size() - 1);
    }
  }
  findOffers();
}

/// Finds the largest set of solutions that can all have their inputs: starts with all and removes those that
/// cannot until nothing changes. (Two processes may need each other's packages; that is no obstacle.)
void LayoutIndex::findOffers() {
  std::size_t before = 0;
  for (const auto& [package, place] : producers_) yielded_.insert(package);
  do {
    before = yielded_.size();
    std::set<std::string> still;
    for (const Place& place : places_) {
      for (const TaskCatalog::Solution& solution : place.task->solutions) {
        if (!obstacle(place, solution).empty()) continue;
        for (const std::string& output : solution.outputs) {
          if (!layout_.withheld.contains(output)) still.insert(output);
        }
      }
    }
    yielded_ = std::move(still);
  } while (yielded_.size() != before);
}

const LayoutIndex::Place* LayoutIndex::placeOf(const std::string& task) const {
  const auto found = std::find_if(places_.begin(), places_.end(),
                                  [&](const Place& place) { return place.entry->task == task; });
  return found == places_.end() ? nullptr : &*found;
}

const LayoutIndex::Place* LayoutIndex::producer(const std::string& package) const {
  const auto found = producers_.find(package);
  return found == producers_.end() ? nullptr : &places_[found->second];
}

bool LayoutIndex::platformOffers(const std::string& package) const {
  return contains(platform_.offers, package);
}

bool LayoutIndex::debugOffers(const std::string& package) const {
  return contains(platform_.debugOffers, package) && debugProcess() != nullptr;
}

const Layout::Process* LayoutIndex::debugProcess() const {
  const auto& all = layout_.processes;
  const auto found = std::find_if(all.begin(), all.end(), [](const Layout::Process& p) { return p.debug; });
  return found == all.end() ? nullptr : &*found;
}

bool LayoutIndex::offered(const std::string& package) const {
  return platformOffers(package) || debugOffers(package) || yielded_.count(package) > 0;
}

LayoutIndex::Obstacle LayoutIndex::obstacle(const Place& place, const std::string& package) const {
  if (!offered(package)) return {notProvided(package)};
  const Place* from = producer(package);
  if (from == nullptr || from->process != place.process || from->position < place.position) return {};
  if (from->position == place.position) return {"only the task itself yields " + package, from};
  return {package + " comes from " + from->entry->task + ", which runs later in the same process", from};
}

std::string LayoutIndex::obstacle(const Place& place, const TaskCatalog::Solution& solution) const {
  for (const std::string& package : solution.required) {
    if (const Obstacle found = obstacle(place, package); !found.reason.empty()) return found.reason;
  }
  return {};
}

std::set<std::string> LayoutIndex::outputsOf(const TaskCatalog::Task& task) const {
  std::set<std::string> outputs;
  for (const TaskCatalog::Solution& solution : task.solutions) {
    outputs.insert(solution.outputs.begin(), solution.outputs.end());
  }
  for (const std::string& package : layout_.withheld) outputs.erase(package);
  return outputs;
}

bool LayoutIndex::needs(const TaskCatalog::Solution& solution, const std::string& package) {
  return contains(solution.required, package);
}

bool LayoutIndex::reads(const TaskCatalog::Solution& solution, const std::string& package) {
  return needs(solution, package) || contains(solution.optional, package);
}

}  // namespace robotlink
