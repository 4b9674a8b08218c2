// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/TaskCatalog.h"

#include <algorithm>

namespace robotlink {

const TaskCatalog::Task* TaskCatalog::find(const std::string& task) const {
  const auto found = tasks.find(task);
  return found == tasks.end() ? nullptr : &found->second;
}

const TaskCatalog::Solution* TaskCatalog::find(const std::string& task, const std::string& solution) const {
  const Task* found = find(task);
  if (found == nullptr) return nullptr;
  const auto& all = found->solutions;
  const auto at = std::find_if(all.begin(), all.end(), [&](const Solution& s) { return s.name == solution; });
  return at == all.end() ? nullptr : &*at;
}

}  // namespace robotlink
