// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/spread/OtherProgram.h"

#include <thread>

#include "app/core/program/RobotFiles.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;

namespace {

constexpr std::chrono::milliseconds kOtherLook{10};

}  // namespace

OtherProgram::OtherProgram(Parts parts) : parts_(std::move(parts)) {}

OtherProgram::~OtherProgram() {
  executor_.reset();
  program_.reset();
}

tl::expected<std::unique_ptr<OtherProgram>, Errors> OtherProgram::create(Parts parts) {
  std::unique_ptr<OtherProgram> made(new OtherProgram(std::move(parts)));
  if (Errors errors = made->make(); !errors.empty()) return tl::unexpected(std::move(errors));
  return made;
}

Errors OtherProgram::make() {
  const HostedRobot& robot = parts_.robot;
  const auto network = spreadNetworkOf(parts_.layout, parts_.options);
  if (!network) return {network.error()};
  auto node = robotlink::dds::Node::open(network->node);
  if (!node) return {node.error()};
  node_ = std::move(*node);
  auto presence = robotlink::dds::ProgramPresence::claim(
      node_, {robot.name, parts_.options.program, robotlink::dds::ProgramPresence::here()}, parts_.report);
  if (!presence) return {presence.error()};
  presence_ = std::move(*presence);
  if (const auto followed = clock_.follow(node_, robot.name); !followed) return {followed.error()};
  auto life = robotlink::dds::LifeSign::open(node_, robot.name);
  if (!life) return {life.error()};
  life_ = std::move(*life);
  net_ = std::make_unique<robotlink::dds::ProgramNet>(
      node_, robotlink::dds::ProgramNet::Identity{robot.name, parts_.options.program}, clock_,
      robotlink::dds::ProgramNet::Behavior{{}, parts_.report});
  platform_ = parts_.platform(clock_);
  auto program = robotlink::RobotProgram::create(
      {robot.name, robot.team, *robot.description, robot.field, robot.map}, parts_.layout, *platform_,
      {.folder = parameterFolder(*robot.description), .recorded = {}},
      robotlink::RobotProgram::Part{parts_.options.program, net_.get()});
  if (!program) return program.error();
  program_ = std::move(*program);
  parts_.report(network->note);
  executor_ = std::make_unique<robotlink::ThreadExecutor>(robotlink::ThreadExecutor::Options{
      .onFailed =
          [this](const robotlink::Process& process) {
            parts_.report("Process " + process.name() +
                          " was stopped because it threw: " + process.failure());
          },
      .onPriorityRefused =
          [this](const robotlink::Process& process, const std::string& why) {
            parts_.report("Process " + process.name() + " runs with normal priority: " + why);
          }});
  for (robotlink::Process* process : program_->processes()) executor_->add(*process);
  return {};
}

bool OtherProgram::run(double seconds, const std::function<bool()>& interrupted) {
  const auto end = std::chrono::steady_clock::now() + robotlink::fromSeconds(seconds);
  while (!interrupted() && (seconds == 0 || std::chrono::steady_clock::now() < end)) {
    const bool before = begun_;
    if (begin() && !before) parts_.report("The program with the platform runs.");
    std::this_thread::sleep_for(kOtherLook);
  }
  return begun_;
}

bool OtherProgram::begin() {
  if (begun_ || !clock_.isSet()) return begun_;
  executor_->start();
  return begun_ = true;
}

}  // namespace app
