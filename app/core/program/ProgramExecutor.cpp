// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramExecutor.h"

namespace app {

const char* nameOf(ExecutorKind kind) {
  return kind == ExecutorKind::kLockstep ? "lockstep" : "threads";
}

ProgramExecutor::ProgramExecutor(Options options) : options_(std::move(options)) {
  const auto failed = [this](const robotlink::Process& process) {
    options_.trouble(process, "was stopped because it threw: " + process.failure());
  };
  if (options_.kind == ExecutorKind::kLockstep) {
    lockstep_ = std::make_unique<robotlink::LockstepExecutor>(robotlink::LockstepExecutor::Options{
        .starvation = std::chrono::seconds(2),
        .advance = options_.advance,
        .onStarved = [this](const auto& process,
                            const auto& what) { options_.trouble(process, "waits for " + what); },
        .onFailed = failed});
  } else {
    threads_ = std::make_unique<robotlink::ThreadExecutor>(robotlink::ThreadExecutor::Options{
        .onFailed = failed, .onPriorityRefused = [this](const auto& process, const auto& why) {
          options_.trouble(process, "runs with normal priority: " + why);
        }});
  }
}

ProgramExecutor::~ProgramExecutor() = default;

void ProgramExecutor::add(robotlink::Platform& platform, const std::vector<robotlink::Process*>& processes) {
  if (lockstep_) lockstep_->add(platform);
  if (threads_) platforms_.push_back(&platform);
  for (robotlink::Process* process : processes) {
    if (lockstep_) lockstep_->add(*process);
    if (threads_) threads_->add(*process);
  }
}

void ProgramExecutor::start() {
  if (threads_) threads_->start();
}

void ProgramExecutor::step() {
  if (lockstep_) {
    lockstep_->step();
  } else {
    stepPlatforms();
  }
}

void ProgramExecutor::stepFromSensors() {
  lockstep_->stepPlatforms();
  lockstep_->runProcesses();
}

void ProgramExecutor::stepPlatforms() {
  for (robotlink::Platform* platform : platforms_) {
    platform->tryBeginFrame();
    platform->guard([&] { platform->actuate(); });
  }
  options_.advance();
  for (robotlink::Platform* platform : platforms_) platform->runFrame();
  threads_->clockAdvanced();
}

}  // namespace app
