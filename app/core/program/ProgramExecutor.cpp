// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramExecutor.h"

#include <algorithm>

namespace app {
namespace {

using robotlink::Process;

/// How long the end of a frame is waited for when all are stopped.
constexpr std::chrono::milliseconds kEndPatience{300};

/// The process whose task is being executed; null if none is.
const Process* busyProcess(const std::vector<Process*>& processes) {
  const auto found =
      std::ranges::find_if(processes, [](const Process* one) { return one->activity() != nullptr; });
  return found == processes.end() ? nullptr : *found;
}

/// "ball-percept (region) of process cognition".
std::string whatRuns(const Process* process) {
  if (process == nullptr) return "its program";
  const std::string* activity = process->activity();
  return (activity != nullptr ? *activity + " of " : std::string()) + "process " + process->name();
}

}  // namespace

std::string taskOf(const Process& process) {
  const std::string* activity = process.activity();
  return activity != nullptr ? *activity : "its program";
}

const char* nameOf(ExecutorKind kind) {
  return kind == ExecutorKind::kLockstep ? "lockstep" : "threads";
}

ProgramExecutor::ProgramExecutor(Options options)
    : options_(std::move(options)),
      patience_(options_.cut ? options_.cut : std::make_shared<const ModulePatience>(options_.patience)) {
  if (options_.kind == ExecutorKind::kLockstep) {
    auto lockstep = lockstepOptions();
    lockstep.advance = options_.advance;
    lockstep_ = std::make_unique<robotlink::LockstepExecutor>(std::move(lockstep));
    return;
  }
  const auto trouble = [muted = isMuted_, report = options_.trouble](const Process& process,
                                                                     const std::string& text) {
    if (!muted->load()) report(process, text);
  };
  threads_ = std::make_unique<robotlink::ThreadExecutor>(robotlink::ThreadExecutor::Options{
      .onFailed = [trouble](const Process& process) { trouble(process, kStoppedText + process.failure()); },
      .onPriorityRefused = [trouble](
                               const Process& process,
                               const auto& why) { trouble(process, "runs with normal priority: " + why); },
      .onStarted = options_.started});
}

robotlink::LockstepExecutor::Options ProgramExecutor::lockstepOptions() const {
  const auto trouble = [muted = isMuted_, report = options_.trouble](const Process& process,
                                                                     const std::string& text) {
    if (!muted->load()) report(process, text);
  };
  return {.starvation = std::chrono::seconds(2),
          .advance = {},
          .onStarved = [trouble](const auto& process,
                                 const auto& what) { trouble(process, "waits for " + what); },
          .onFailed = [trouble](const auto& process) { trouble(process, kStoppedText + process.failure()); }};
}

ProgramExecutor::~ProgramExecutor() = default;

void ProgramExecutor::add(robotlink::Platform& platform, const std::vector<Process*>& processes,
                          Guard guard) {
  Team& team = *teams_.emplace_back(std::make_unique<Team>());
  team.platform = &platform;
  team.processes = processes;
  if (lockstep_) lockstep_->add(platform);
  if (threads_ && guard != Guard::kStandIn) {
    for (Process* process : processes) threads_->add(*process);
  } else if (lockstep_ && options_.patience.count() == 0) {
    for (Process* process : processes) lockstep_->add(*process);
  } else {
    team.lockstep = std::make_unique<robotlink::LockstepExecutor>(lockstepOptions());
    for (Process* process : processes) team.lockstep->add(*process);
    if (guard != Guard::kYes) return;
    team.turns =
        std::make_unique<TurnThread>([&team] { team.lockstep->runProcesses(team.platform->clock().now()); });
  }
}

void ProgramExecutor::start() {
  if (threads_) threads_->start();
}

void ProgramExecutor::step() {
  if (threads_) return stepPlatforms();
  runProcesses();
  lockstep_->stepPlatforms();
}

void ProgramExecutor::stepFromSensors() {
  lockstep_->stepPlatforms();
  runProcesses();
}

void ProgramExecutor::runProcesses() {
  if (options_.patience.count() == 0) return lockstep_->runProcesses();
  for (const auto& team : teams_) takeTurn(*team);
}

void ProgramExecutor::takeTurn(Team& team) {
  if (!team.turns) return team.lockstep->runProcesses(team.platform->clock().now());
  if (team.turns->isBusy()) return;
  if (team.isStuck) setStuck(team, false, nullptr);
  if (!team.turns->run(*patience_)) setStuck(team, true, busyProcess(team.processes));
}

void ProgramExecutor::setStuck(Team& team, bool isStuck, const Process* process) {
  team.isStuck = isStuck;
  if (options_.stuck) options_.stuck(*team.platform, isStuck ? whatRuns(process) : std::string());
}

void ProgramExecutor::watchThreads() {
  if (options_.patience.count() == 0) return;
  for (const auto& team : teams_) {
    const auto late = std::ranges::find_if(team->processes, [this](const Process* process) {
      return threads_->busyFor(*process) > options_.patience;
    });
    const bool isStuck = late != team->processes.end();
    if (isStuck != team->isStuck) setStuck(*team, isStuck, isStuck ? *late : nullptr);
  }
}

bool ProgramExecutor::isStuck(const robotlink::Platform& platform) const {
  const auto team = std::ranges::find(teams_, &platform, [](const auto& one) { return one->platform; });
  return team != teams_.end() && (*team)->isStuck;
}

void ProgramExecutor::stepPlatforms() {
  for (const auto& team : teams_) {
    if (team->lockstep) team->lockstep->runProcesses(team->platform->clock().now());
    team->platform->tryBeginFrame();
    team->platform->guard([&] { team->platform->actuate(); });
  }
  options_.advance();
  for (const auto& team : teams_) team->platform->runFrame();
  threads_->clockAdvanced();
  watchThreads();
}

bool ProgramExecutor::stop() {
  isMuted_->store(true);
  if (threads_) return threads_->stopWithin(kEndPatience);
  const auto isBusy = [](const auto& team) { return team->turns && team->turns->isBusy(); };
  for (const auto& team : teams_) {
    if (!isBusy(team)) continue;
    for (Process* process : team->processes) process->stop();
  }
  // All have the same time, however many do not return.
  const auto end = std::chrono::steady_clock::now() + kEndPatience;
  for (const auto& team : teams_) {
    if (!isBusy(team)) continue;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    team->turns->waitFor(std::max(left, std::chrono::milliseconds(0)));
  }
  return hasEnded();
}

bool ProgramExecutor::hasEnded(const Team& team) const {
  if (!threads_) return !team.turns || !team.turns->isBusy();
  return std::ranges::all_of(team.processes,
                             [this](const Process* process) { return threads_->hasEnded(*process); });
}

bool ProgramExecutor::hasEnded() const {
  return std::ranges::all_of(teams_, [this](const auto& team) { return hasEnded(*team); });
}

bool ProgramExecutor::hasEnded(const robotlink::Platform& platform) const {
  return std::ranges::all_of(
      teams_, [&](const auto& team) { return team->platform != &platform || hasEnded(*team); });
}

}  // namespace app
