// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/RunningPrograms.h"

namespace app {
namespace {

/// Whether the program of such a robot reads a file when it starts. Color tables are used at once.
bool readsAtStart(const std::string& path, const RunningPrograms::Program& program) {
  return path == "layouts/" + program.layout || path.starts_with("parameters/" + program.kind + "/") ||
         path.starts_with("motions/") || path == presetPathOf(program.robot);
}

}  // namespace

std::string presetPathOf(const std::string& robot) {
  return "presets/" + robot + ".preset.json";
}

void RunningPrograms::set(const std::vector<Program>& programs) {
  const std::lock_guard lock(mutex_);
  std::map<std::string, Robot> robots;
  for (const Program& program : programs) {
    const auto before = robots_.find(program.robot);
    robots[program.robot] = {program.kind, program.layout, before == robots_.end() ? 0 : before->second.read};
  }
  robots_ = std::move(robots);
}

void RunningPrograms::noteWritten(const std::string& path) {
  const std::lock_guard lock(mutex_);
  written_[path] = ++newest_;
}

void RunningPrograms::noteStarted(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  if (const auto found = robots_.find(robot); found != robots_.end()) found->second.read = newest_;
}

std::vector<RunningPrograms::Program> RunningPrograms::programs() const {
  const std::lock_guard lock(mutex_);
  std::vector<Program> all;
  for (const auto& [name, robot] : robots_) {
    Program& program = all.emplace_back(Program{name, robot.kind, robot.layout});
    for (const auto& [path, number] : written_)
      if (number > robot.read && readsAtStart(path, program)) program.waiting.push_back(path);
  }
  return all;
}

}  // namespace app
