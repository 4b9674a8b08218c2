// SPDX-License-Identifier: GPL-3.0-or-later
// What the user chooses in a ReplayRun.
#include <algorithm>

#include "app/platforms/replay/ReplayRun.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace app {

using robotcontrol::ControlReplay;
using robotlink::Duration;
using robotlink::Errors;

// The programs of a jump begin before now(), where the log may have another setup.
Errors ReplayRun::change(const Change& change) {
  for (const auto& source : logs_.sources()) {
    for (const auto& robot : source->robots) {
      ReplayChoices choices = robot->choices();
      change(robot->name(), choices);
      const auto tried = robot->prepare(source->inLog(now_), std::move(choices));
      if (!tried) return tried.error();
    }
  }
  return jump(now_, change);
}

Errors ReplayRun::choosePackages(const std::map<std::string, ControlReplay::PackageSource>& packages) {
  for (const auto& [package, source] : packages) {
    const std::string robot = package.substr(0, package.find('/'));
    if (logs_.find(robot) != nullptr) continue;
    return {{"replay.no-robot", "there is no robot " + robot + " in the logs", {robot}, {}}};
  }
  return change([&](const std::string& robot, ReplayChoices& choices) {
    for (const auto& [package, source] : packages) {
      if (package.starts_with(robot + "/")) choices.packages[package.substr(robot.size() + 1)] = source;
    }
  });
}

Errors ReplayRun::hostProgram(const std::string& name, const robotcontrol::HostProgram& choice) {
  using robotcontrol::HostProgram;
  if (!name.empty() && logs_.find(name) == nullptr)
    return {{"request.no-robot", "there is no robot " + name + " in the logs", {name}, {}}};
  if (choice.executor() == HostProgram::THREADS)
    return {{"program.lockstep",
             "programs on logs run in lockstep, so that the same log gives the same results",
             {},
             {}}};
  if (choice.where() == HostProgram::UNCHANGED) return choice.start_again() ? jump(now_) : Errors{};
  const bool own = choice.where() == HostProgram::OWN_PROCESS;
  Errors errors = jump(now_, [&](const std::string& robot, ReplayChoices& choices) {
    if (name.empty() || robot == name) choices.hosting.ownProcess = own;
  });
  if (errors.empty()) options_.hosting.choose(name, own);
  return errors;
}

Errors ReplayRun::setLayout(const std::filesystem::path& file) {
  Errors errors = change([&](const std::string&, ReplayChoices& choices) { choices.layout = file; });
  if (errors.empty()) options_.layout = file;
  return errors;
}

Errors ReplayRun::setOffsets(const std::map<std::filesystem::path, Duration>& offsets) {
  const std::vector<ReplayLog> before = options_.logs;
  for (ReplayLog& log : options_.logs) {
    if (const auto offset = offsets.find(log.file); offset != offsets.end())
      log = {log.file, offset->second, true};
  }
  Errors errors = jump(now_);
  // The sources refer to the elements, which stay where they are.
  if (!errors.empty()) std::ranges::copy(before, options_.logs.begin());
  return errors;
}

robotlink::Result<void> ReplayRun::request(const robotcontrol::Request& request) {
  if (ReplayRobot* robot = logs_.find(request.robot())) return robot->host().request(request);
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot() + " in the logs", {},
                            {request.robot()});
}

std::vector<ReplayRun::Answers> ReplayRun::answersToCome() {
  std::vector<Answers> all;
  for (const auto& source : logs_.sources()) {
    for (const auto& robot : source->robots) {
      if (const auto queue = robot->host().answersToCome())
        all.emplace_back(robot->name(), onLine(queue, source->log.offset));
    }
  }
  return all;
}

robotlink::Result<void> ReplayRun::runShadows(const std::vector<robotlink::ShadowName>& shadows) {
  for (const auto& [task, solution] : shadows) {
    robotcontrol::Request wanted;
    wanted.mutable_set_key()->set_name(robotlink::shadowKey(task, solution));
    wanted.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    std::string refusal = "no robot of the log is known here";
    for (const std::string& robot : robots()) {
      wanted.set_robot(robot);
      wanted.set_id(wanted.id() + 1);
      if (const auto asked = request(wanted); !asked) refusal = asked.error().text;
    }
    bool runs = false;
    for (const auto& [robot, queue] : answersToCome()) {
      for (const auto& message : queue->messages) {
        const auto* result = message.as<robotcontrol::RequestResult>();
        if (result == nullptr) continue;
        runs = runs || result->accepted();
        if (!result->accepted()) refusal = robot + ": " + result->reason();
      }
    }
    if (!runs)
      return robotlink::failure("replay.shadow",
                                solution + " of " + task + " cannot run in the shadow; " + refusal +
                                    ". A task only runs if its output is recomputed (--package)",
                                {}, {task, solution});
  }
  return {};
}

}  // namespace app
