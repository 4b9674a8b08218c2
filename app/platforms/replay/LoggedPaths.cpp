// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/LoggedPaths.h"

#include <algorithm>
#include <string_view>

#include "foxglove/Scene.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"

namespace app {

namespace streams = robotlink::streams;

namespace {

/// Returns what follows a prefix; empty if the path does not begin with it.
std::string below(const std::string& path, std::string_view prefix) {
  return path.starts_with(prefix) ? path.substr(prefix.size()) : std::string();
}

}  // namespace

LoggedPaths::LoggedPaths(const ReplayPlan& plan) {
  for (const auto& process : plan.layout.processes) {
    processes_.insert(process.name);
    for (const auto& task : process.tasks) tasks_.insert(task.task);
  }
  for (const auto& package : plan.packages) {
    const bool yielded = package.canRecompute && !package.process.empty() && !plan.isAsLogged(package.name);
    if (yielded) recomputed_.insert(package.name);
  }
  for (const auto& solution : robotlink::SolutionRegistry::all()) {
    if (!tasks_.contains(solution.task)) continue;
    const auto reads = [&](const char* package) {
      return std::ranges::find(solution.required, package) != solution.required.end() ||
             std::ranges::find(solution.optional, package) != solution.optional.end();
    };
    looksAtColors_ = looksAtColors_ || reads(robotlink::kColorTable.name);
    playsMotions_ = playsMotions_ || reads(robotlink::kMotionTexts.name);
    for (const int key : solution.keys)
      keys_.insert(robotlink::DebugKey::all()[static_cast<std::size_t>(key)].name);
  }
}

bool LoggedPaths::isRecomputed(const std::string& path, const google::protobuf::Message& value) const {
  if (path == streams::kLog) {
    const auto* text = dynamic_cast<const foxglove::Log*>(&value);
    return text != nullptr && isRecomputedText(text->name());
  }
  const auto [known, isNew] = known_.try_emplace(path, false);
  if (isNew) known->second = decide(path);
  return known->second;
}

bool LoggedPaths::decide(const std::string& path) const {
  // These are published in any case: by the debug process, which knows them for the whole program. If it is
  // the only process, it publishes keys of no task, so those of the log stay.
  if (path == streams::kSolutions || path == streams::kProcesses || path == streams::kProgram) return true;
  if (path == streams::kKeys) return !tasks_.empty();
  if (path == streams::kColorTableInUse) return looksAtColors_;
  if (path == streams::kMotions) return playsMotions_;
  if (recomputed_.contains(path)) return true;
  for (const char* prefix : {streams::kImages, streams::kImageDrawings, streams::kFieldDrawings,
                             streams::kRobotDrawings, streams::kPlots}) {
    if (const std::string key = below(path, prefix); !key.empty()) return isRecomputedKey(key);
  }
  for (const char* prefix : {streams::kFrames, streams::kStopwatches, "tables/keys/", "tables/solutions/"}) {
    if (const std::string process = below(path, prefix); !process.empty()) return runs(process);
  }
  if (const std::string shadowed = below(path, streams::kShadow); !shadowed.empty())
    return decide(shadowed.substr(std::min(shadowed.find('/') + 1, shadowed.size())));
  const std::string parameters = below(path, streams::kParameters);
  return !parameters.empty() && tasks_.contains(parameters.substr(0, parameters.find('/')));
}

bool LoggedPaths::isRecomputedKey(std::string key) const {
  while (!keys_.contains(key)) {
    const auto slash = key.rfind('/');
    if (slash == std::string::npos) return false;
    key.resize(slash);
  }
  return true;
}

bool LoggedPaths::isRecomputedText(const std::string& source) const {
  const auto slash = source.find('/');
  const std::string publisher = slash == std::string::npos ? "" : source.substr(slash + 1);
  const auto& all = robotlink::SolutionRegistry::all();
  const bool isTask =
      std::ranges::any_of(all, [&](const auto& solution) { return solution.task == publisher; });
  return isTask ? tasks_.contains(publisher) : runs(source.substr(0, slash));
}

}  // namespace app
