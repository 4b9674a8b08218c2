// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugRoutes.h"

#include <algorithm>
#include <string_view>

#include "robotlink/debugging/Streams.h"

namespace robotlink {
namespace {

constexpr std::string_view kPackagePrefix = "package/";

}  // namespace

std::string packageKey(const std::string& package) {
  return std::string(kPackagePrefix) + package;
}

std::string packageOfKey(const std::string& key) {
  return key.starts_with(kPackagePrefix) ? key.substr(kPackagePrefix.size()) : std::string();
}

std::string shadowKey(const std::string& task, const std::string& solution) {
  return streams::kShadow + task + '/' + solution;
}

std::optional<ShadowName> shadowOfKey(const std::string& key) {
  if (!key.starts_with(streams::kShadow)) return std::nullopt;
  const std::string name = key.substr(std::string_view(streams::kShadow).size());
  const auto slash = name.find('/');
  if (slash == std::string::npos) return std::nullopt;
  return ShadowName{name.substr(0, slash), name.substr(slash + 1)};
}

std::string shadowPrefix(const std::string& solution) {
  return streams::kShadow + solution + '/';
}

std::string DebugRoutes::processOf(const std::string& task) const {
  for (const TaskList& list : processes) {
    if (std::find(list.tasks.begin(), list.tasks.end(), task) != list.tasks.end()) return list.process;
  }
  return {};
}

DebugRoutes debugRoutes(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform) {
  DebugRoutes routes;
  routes.absent = layout.absent;
  for (const Layout::Process& process : layout.processes) {
    if (process.debug) continue;
    auto& list = routes.processes.emplace_back(DebugRoutes::TaskList{process.name, {}});
    for (const Layout::Task& task : process.tasks) {
      list.tasks.push_back(task.task);
      const TaskCatalog::Task* known = catalog.find(task.task);
      if (known == nullptr) continue;
      for (const TaskCatalog::Solution& solution : known->solutions) {
        for (const std::string& output : solution.outputs) {
          if (!layout.withheld.contains(output)) routes.packages.emplace(output, process.name);
        }
      }
    }
  }
  for (const LayoutLink& link : layoutLinks(layout, catalog, platform)) {
    if (!link.to.empty()) routes.packages.emplace(link.package, link.to);  // unless a task yields it
  }
  return routes;
}

}  // namespace robotlink
