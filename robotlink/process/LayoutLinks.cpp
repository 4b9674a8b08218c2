// SPDX-License-Identifier: GPL-3.0-or-later
// layoutLinks() and unavailability() of Layout.h: the links that follow from inputs and outputs.
#include <algorithm>

#include "robotlink/process/LayoutIndex.h"

namespace robotlink {
namespace {

/// The packages that the tasks of a process read, in their order, and those that only trigger it; the bool is
/// true where a solution requires the package.
std::vector<std::pair<std::string, bool>> packagesRead(const LayoutIndex& index,
                                                       const Layout::Process& process) {
  std::vector<std::pair<std::string, bool>> read;
  const auto add = [&](const std::string& package, bool required) {
    const auto found =
        std::find_if(read.begin(), read.end(), [&](const auto& entry) { return entry.first == package; });
    if (found == read.end()) {
      read.emplace_back(package, required);
    } else {
      found->second = found->second || required;
    }
  };
  for (const LayoutIndex::Place& place : index.places()) {
    if (place.process != &process) continue;
    for (const TaskCatalog::Solution& solution : place.task->solutions) {
      for (const std::string& package : solution.required) add(package, true);
      for (const std::string& package : solution.optional) add(package, false);
    }
  }
  for (const Layout::Input& input : process.blocking) {
    if (input.paceOnly) add(input.package, true);
  }
  return read;
}

void addLinksTo(const Layout::Process& process, const LayoutIndex& index, std::vector<LayoutLink>& links) {
  for (const auto& [package, required] : packagesRead(index, process)) {
    const LayoutIndex::Place* producer = index.producer(package);
    std::string from;
    if (producer != nullptr) {
      if (producer->process == &process) continue;
      from = producer->process->name;
    } else if (index.debugOffers(package)) {
      from = index.debugProcess()->name;
    } else if (!index.platformOffers(package)) {
      continue;
    }
    const bool blocking =
        std::any_of(process.blocking.begin(), process.blocking.end(),
                    [&, &name = package](const Layout::Input& input) { return input.package == name; });
    links.push_back({package, from, process.name, blocking, !required});
  }
}

}  // namespace

std::vector<LayoutLink> layoutLinks(const Layout& layout, const TaskCatalog& catalog,
                                    const PlatformPackages& platform) {
  const LayoutIndex index(layout, catalog, platform);
  std::vector<LayoutLink> links;
  for (const Layout::Process& process : layout.processes) addLinksTo(process, index, links);
  for (const std::string& package : platform.takes) {
    const LayoutIndex::Place* producer = index.producer(package);
    if (producer != nullptr) links.push_back({package, producer->process->name, "", false, true});
  }
  return links;
}

std::string unavailability(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform,
                           const std::string& task, const std::string& solution) {
  const LayoutIndex index(layout, catalog, platform);
  const LayoutIndex::Place* place = index.placeOf(task);
  const TaskCatalog::Solution* known = catalog.find(task, solution);
  if (place == nullptr) return "unavailable because no process does the task " + task;
  if (known == nullptr) return "unavailable because task " + task + " has no such solution";
  const std::string reason = index.obstacle(*place, *known);
  return reason.empty() ? "" : "unavailable because " + reason;
}

}  // namespace robotlink
