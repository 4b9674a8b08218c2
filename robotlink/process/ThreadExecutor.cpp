// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/ThreadExecutor.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace robotlink {
namespace {

/// Returns the reason for a failure; empty on success.
std::string setNiceOfThisThread(int nice) {
  if (nice == 0) return {};
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  if (::setpriority(PRIO_PROCESS, thread, nice) == 0) return {};
  return std::strerror(errno);
}

std::int64_t steadyNanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

ThreadExecutor::ThreadExecutor(Options options) : options_(std::move(options)) {}

ThreadExecutor::~ThreadExecutor() {
  stop();
}

void ThreadExecutor::start() {
  for (Process* process : processes_) {
    Slot& slot = *slots_.emplace_back(std::make_unique<Slot>(*process));
    slot.thread = std::thread([this, &slot] { run(slot); });
  }
}

void ThreadExecutor::run(Slot& slot) {
  Process& process = slot.process;
  const std::string refused = setNiceOfThisThread(process.priority());
  if (!refused.empty() && options_.onPriorityRefused) options_.onPriorityRefused(process, refused);
  if (options_.onStarted) options_.onStarted(process);
  constexpr std::chrono::milliseconds kLimit{1000};
  while (process.waitForFrame(kLimit)) {
    slot.since.store(steadyNanoseconds());
    process.runFrame();
    slot.since.store(0);
  }
  if (!process.failure().empty() && options_.onFailed) options_.onFailed(process);
  {
    const std::lock_guard lock(mutex_);
    slot.hasEnded.store(true);
  }
  ended_.notify_all();
}

std::chrono::nanoseconds ThreadExecutor::busyFor(const Process& process) const {
  for (const auto& slot : slots_) {
    if (&slot->process != &process) continue;
    const std::int64_t since = slot->since.load();
    return std::chrono::nanoseconds(since == 0 ? 0 : steadyNanoseconds() - since);
  }
  return {};
}

void ThreadExecutor::clockAdvanced() {
  for (Process* process : processes_) {
    if (process->period() > Duration::zero()) process->wake();
  }
}

bool ThreadExecutor::hasEnded() const {
  return std::ranges::all_of(slots_, [](const auto& slot) { return slot->hasEnded.load(); });
}

bool ThreadExecutor::hasEnded(const Process& process) const {
  return std::ranges::all_of(
      slots_, [&](const auto& slot) { return &slot->process != &process || slot->hasEnded.load(); });
}

bool ThreadExecutor::stopWithin(std::chrono::milliseconds limit) {
  for (Process* process : processes_) process->stop();
  {
    std::unique_lock lock(mutex_);
    ended_.wait_for(lock, limit, [this] { return hasEnded(); });
  }
  forgetEnded();
  return hasEnded();
}

void ThreadExecutor::forgetEnded() {
  std::erase_if(slots_, [](const auto& slot) {
    const bool isOver = slot->hasEnded.load();
    if (isOver) slot->thread.join();
    return isOver;
  });
  processes_.clear();
  for (const auto& slot : slots_) processes_.push_back(&slot->process);
}

void ThreadExecutor::stop() {
  for (Process* process : processes_) process->stop();
  for (const auto& slot : slots_) {
    if (slot->thread.joinable()) slot->thread.join();
  }
  slots_.clear();
}

}  // namespace robotlink
