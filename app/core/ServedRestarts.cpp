// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedRestarts.h"

#include <algorithm>

#include "app/core/PlatformThread.h"
#include "app/core/remote/ProgramNotes.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;

/// The robot whose program has just begun; empty: none.
std::string startedIn(const robotlink::StreamMessage& message) {
  const auto* status = dynamic_cast<const HostingStatus*>(message.value.get());
  const bool isNew = status != nullptr && status->state() == HostingStatus::RUNNING && status->text().empty();
  return isNew ? message.path.substr(0, message.path.find('/')) : std::string();
}

}  // namespace

ServedRestarts::ServedRestarts(robotlink::Session& session, PlatformThread& platform)
    : session_(session),
      platform_(platform),
      listener_(session.addListener({[this](const robotlink::StreamMessage& message) {
                                       if (const std::string robot = startedIn(message); !robot.empty())
                                         programs_->noteStarted(robot);
                                     },
                                     {}})),
      outcomes_(std::make_shared<robotlink::BoundedQueue<Outcome>>(100)) {}

ServedRestarts::~ServedRestarts() {
  session_.removeListener(listener_);
}

void ServedRestarts::ask(const std::string& robot, const std::filesystem::path& layout, Done done) {
  asked_.push({robot, layout, std::move(done)});
}

void ServedRestarts::setLoaded(const LoadedPlatform& loaded) {
  std::vector<RunningPrograms::Program> programs;
  for (const auto& [name, description] : loaded.robots)
    programs.push_back(
        {name, description ? description->name : std::string(), loaded.layoutOf(name).filename().string()});
  programs_->set(programs);
}

void ServedRestarts::tick() {
  for (Asked& asked : asked_.drain()) begin(std::move(asked));
  for (const Outcome& outcome : outcomes_->drain()) finish(outcome);
}

void ServedRestarts::begin(Asked asked) {
  const auto programs = programs_->programs();
  const auto program = std::ranges::find(programs, asked.robot, &RunningPrograms::Program::robot);
  if (program == programs.end()) return asked.done("there is no robot '" + asked.robot + "' here");
  if (!asked.layout.empty() && asked.layout.filename() != program->layout) {
    platform_.setLayout(asked.layout, [outcomes = outcomes_, done = asked.done](const Loaded& loaded) {
      outcomes->push({loaded, done});
    });
    return;
  }
  robotcontrol::Request request;
  request.set_robot(asked.robot);
  request.mutable_host_program()->set_start_again(true);
  session_.request(std::move(request), [programs = programs_, asked](const auto& result) {
    if (result.accepted()) programs->noteStarted(asked.robot);
    asked.done(result.accepted() ? std::string() : result.reason());
  });
}

void ServedRestarts::finish(const Outcome& outcome) {
  if (!outcome.loaded) return outcome.done(robotlink::describe(outcome.loaded.error()));
  setLoaded(*outcome.loaded);
  for (const auto& [name, description] : outcome.loaded->robots) programs_->noteStarted(name);
  publishPrograms(session_, *outcome.loaded);
  hasChanged_ = true;
  outcome.done({});
}

}  // namespace app
