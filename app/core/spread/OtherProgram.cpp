// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/spread/OtherProgram.h"

#include <unistd.h>

#include <thread>

#include "app/core/program/Abandoned.h"
#include "app/core/program/ProgramExecutor.h"
#include "app/core/program/RobotFiles.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;
using robotlink::Process;

namespace {

constexpr std::chrono::milliseconds kOtherLook{10};
/// The time to wait for the end of frames.
constexpr std::chrono::milliseconds kOtherEnd{300};

robotlink::ThreadExecutor::Options executorOptions(const std::function<void(const std::string&)>& report) {
  return {.onFailed =
              [report](const Process& process) {
                report("Process " + process.name() + " was stopped because it threw: " + process.failure());
              },
          .onPriorityRefused =
              [report](const Process& process, const std::string& why) {
                report("Process " + process.name() + " runs with normal priority: " + why);
              }};
}

}  // namespace

OtherProgram::Running::Running() = default;

OtherProgram::Running::~Running() {
  executor.reset();
  program.reset();
}

OtherProgram::OtherProgram(Parts parts) : parts_(std::move(parts)), running_(std::make_shared<Running>()) {}

OtherProgram::~OtherProgram() {
  const auto* executor = running_->executor.get();
  if (executor == nullptr || running_->executor->stopWithin(kOtherEnd)) return;
  // For the others it has ended.
  running_->life.reset();
  running_->presence.reset();
  abandon(std::move(running_), [executor] { return executor->hasEnded(); });
}

tl::expected<std::unique_ptr<OtherProgram>, Errors> OtherProgram::create(Parts parts) {
  std::unique_ptr<OtherProgram> made(new OtherProgram(std::move(parts)));
  for (const auto part : {&OtherProgram::join, &OtherProgram::make})
    if (Errors errors = (made.get()->*part)(); !errors.empty()) return tl::unexpected(std::move(errors));
  return made;
}

/// Finds its place among the robot's programs.
Errors OtherProgram::join() {
  const std::string& robot = parts_.robot.name;
  const std::string& name = parts_.options.program;
  const auto network = spreadNetworkOf(parts_.layout, parts_.options);
  if (!network) return {network.error()};
  auto node = robotlink::dds::Node::open(network->node);
  if (!node) return {node.error()};
  running_->node = std::move(*node);
  auto presence = robotlink::dds::ProgramPresence::claim(
      running_->node, {robot, name, robotlink::dds::ProgramPresence::here()}, parts_.report);
  if (!presence) return {presence.error()};
  running_->presence = std::move(*presence);
  if (const auto followed = running_->clock.follow(running_->node, robot); !followed)
    return {followed.error()};
  auto life = robotlink::dds::LifeSign::open(running_->node, robot);
  if (!life) return {life.error()};
  running_->life = std::move(*life);
  running_->net = std::make_unique<robotlink::dds::ProgramNet>(
      running_->node, robotlink::dds::ProgramNet::Identity{robot, name}, running_->clock,
      robotlink::dds::ProgramNet::Behavior{{}, parts_.report});
  parts_.report(network->note);
  return {};
}

Errors OtherProgram::make() {
  const HostedRobot& robot = parts_.robot;
  running_->platform = parts_.platform(running_->clock);
  auto program = robotlink::RobotProgram::create(
      {robot.name, robot.team, *robot.description, robot.field, robot.map}, parts_.layout,
      *running_->platform, {.folder = parameterFolder(*robot.description), .recorded = {}},
      robotlink::RobotProgram::Part{parts_.options.program, running_->net.get()});
  if (!program) return program.error();
  running_->program = std::move(*program);
  running_->executor = std::make_unique<robotlink::ThreadExecutor>(executorOptions(parts_.report));
  for (Process* process : running_->program->processes()) running_->executor->add(*process);
  return {};
}

bool OtherProgram::run(double seconds, const std::function<bool()>& interrupted) {
  const auto end = std::chrono::steady_clock::now() + robotlink::fromSeconds(seconds);
  while (!interrupted() && (seconds == 0 || std::chrono::steady_clock::now() < end)) {
    const bool before = begun_;
    if (look() && !before) parts_.report("The program with the platform runs.");
    std::this_thread::sleep_for(kOtherLook);
  }
  return begun_;
}

bool OtherProgram::look() {
  if (begun_) {
    lookForStuck();
  } else if (running_->clock.isSet()) {
    running_->executor->start();
    begun_ = true;
  }
  return begun_;
}

void OtherProgram::lookForStuck() {
  for (const Process* process : running_->program->processes()) {
    const bool isStuck = running_->executor->busyFor(*process) > parts_.patience;
    if (isStuck == stuck_.contains(process)) continue;
    const std::string name = "Process " + process->name();
    if (isStuck) {
      stuck_.insert(process);
      const std::string task = taskOf(*process);
      running_->program->noteStuck(process->name(), task);
      parts_.report(name + " does not return from " + task +
                    ". If it controls the robot, the robot is stopped meanwhile. To attach a debugger: "
                    "gdb -p " +
                    std::to_string(::getpid()));
    } else {
      stuck_.erase(process);
      running_->program->noteStuck(process->name(), {});
      parts_.report(name + " has returned and continues.");
    }
  }
}

}  // namespace app
