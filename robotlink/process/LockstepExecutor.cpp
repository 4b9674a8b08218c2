// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LockstepExecutor.h"

namespace robotlink {

LockstepExecutor::LockstepExecutor(Options options) : options_(std::move(options)) {}

void LockstepExecutor::clear() {
  processes_.clear();
  platforms_.clear();
}

void LockstepExecutor::step() {
  runProcesses();
  stepPlatforms();
}

void LockstepExecutor::runProcesses() {
  if (!platforms_.empty()) runProcesses(platforms_.front().process->clock().now());
}

void LockstepExecutor::runProcesses(Instant now) {
  runUntilNoneCan(now);
  for (Entry& entry : processes_) {
    reportFailure(entry);
    reportStarvation(entry, now);
  }
}

void LockstepExecutor::runUntilNoneCan(Instant now) {
  for (bool ran = true; ran;) {
    ran = false;
    for (Entry& entry : processes_) {
      if (entry.lastRun == now || !entry.process->tryBeginFrame()) continue;
      entry.process->runFrame();
      entry.lastRun = now;
      entry.waitsSince = now;
      entry.starvationReported = false;
      ran = true;
    }
  }
}

void LockstepExecutor::stepPlatforms() {
  for (Entry& entry : platforms_) {
    // Takes what has arrived; platforms step whether they are satisfied or not.
    entry.process->tryBeginFrame();
    if (!entry.process->stopped()) entry.process->guard([&entry] { entry.platform->actuate(); });
  }
  if (options_.advance) options_.advance();
  for (Entry& entry : platforms_) {
    if (!entry.process->stopped()) entry.process->runFrame();
    reportFailure(entry);
  }
}

void LockstepExecutor::reportFailure(Entry& entry) {
  if (entry.failureReported || !entry.process->stopped()) return;
  entry.failureReported = true;
  if (!entry.process->failure().empty() && options_.onFailed) options_.onFailed(*entry.process);
}

void LockstepExecutor::reportStarvation(Entry& entry, Instant now) {
  if (entry.process->stopped()) return;
  if (!entry.waitsSince || now < *entry.waitsSince) entry.waitsSince = now;
  const bool starved = now - *entry.waitsSince > options_.starvation + entry.process->period();
  if (!starved || entry.starvationReported) return;
  entry.starvationReported = true;
  if (options_.onStarved) options_.onStarved(*entry.process, entry.process->waitsFor());
}

}  // namespace robotlink
