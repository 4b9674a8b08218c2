// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramExecutor.h"

#include <algorithm>

namespace app {
namespace {

using robotlink::Process;

/// The time to wait for the end of a frame when all are stopped.
constexpr std::chrono::milliseconds kEndPatience{300};
/// Stands for a patience without end.
constexpr std::chrono::hours kForEver{24 * 365};

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
      patience_(options_.cut && options_.patience.count() > 0
                    ? options_.cut
                    : std::make_shared<const ModulePatience>(options_.patience.count() > 0 ? options_.patience
                                                                                           : kForEver)) {
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
    return;
  }
  team.lockstep = std::make_unique<robotlink::LockstepExecutor>(lockstepOptions());
  for (Process* process : processes) team.lockstep->add(*process);
  team.takesTurns = (isPatient() || options_.pool) && guard == Guard::kYes;
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
  const auto begin = std::chrono::steady_clock::now();
  takeTurns();
  // Programs elsewhere compute meanwhile.
  for (const auto& team : teams_) {
    if (!team->takesTurns) team->lockstep->runProcesses(team->platform->clock().now());
  }
  options_.ran(std::chrono::steady_clock::now() - begin);
}

void ProgramExecutor::makeCrew() {
  // More threads than there are robots would only look for turns.
  const auto robots = std::ranges::count_if(teams_, [](const auto& team) { return team->takesTurns; });
  const int threads = options_.pool ? options_.pool->threads() : 1;
  crew_ = std::make_unique<TurnCrew>(
      std::min(threads, static_cast<int>(robots)), [this](std::size_t team) { takeTurn(team); },
      options_.waiting);
}

void ProgramExecutor::takeTurns() {
  std::vector<std::size_t> turns;
  for (std::size_t i = 0; i < teams_.size(); ++i) {
    if (!teams_[i]->takesTurns || isBusy(i)) continue;
    if (teams_[i]->isStuck) setStuck(*teams_[i], false, nullptr);
    turns.push_back(i);
  }
  if (turns.empty()) return;
  if (!isPatient()) return options_.pool->run(turns.size(), [&](std::size_t i) { takeTurn(turns[i]); });
  if (!crew_) makeCrew();
  for (const std::size_t late : crew_->run(turns, *patience_))
    setStuck(*teams_[late], true, busyProcess(teams_[late]->processes));
}

void ProgramExecutor::takeTurn(std::size_t team) {
  teams_[team]->lockstep->runProcesses(teams_[team]->platform->clock().now());
}

bool ProgramExecutor::isBusy(std::size_t team) const {
  return crew_ && teams_[team]->takesTurns && crew_->isBusy(team);
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
  for (std::size_t i = 0; i < teams_.size(); ++i) {
    if (!isBusy(i)) continue;
    for (Process* process : teams_[i]->processes) process->stop();
  }
  // All have the same time, however many do not return.
  const auto end = std::chrono::steady_clock::now() + kEndPatience;
  for (std::size_t i = 0; i < teams_.size(); ++i) {
    if (!isBusy(i)) continue;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    crew_->waitFor(i, std::max(left, std::chrono::milliseconds(0)));
  }
  return hasEnded();
}

bool ProgramExecutor::hasEnded(std::size_t team) const {
  if (!threads_) return !isBusy(team);
  return std::ranges::all_of(teams_[team]->processes,
                             [this](const Process* process) { return threads_->hasEnded(*process); });
}

bool ProgramExecutor::hasEnded() const {
  for (std::size_t i = 0; i < teams_.size(); ++i) {
    if (!hasEnded(i)) return false;
  }
  return true;
}

bool ProgramExecutor::hasEnded(const robotlink::Platform& platform) const {
  for (std::size_t i = 0; i < teams_.size(); ++i) {
    if (teams_[i]->platform == &platform && !hasEnded(i)) return false;
  }
  return true;
}

}  // namespace app
