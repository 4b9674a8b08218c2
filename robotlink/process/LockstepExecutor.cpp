// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LockstepExecutor.h"

namespace robotlink {

LockstepExecutor::LockstepExecutor(Options options) : options_(std::move(options)) {}

void LockstepExecutor::clear() {
  processes_.clear();
  platforms_.clear();
  started_ = false;
}

void LockstepExecutor::step() {
  if (platforms_.empty()) return;
  const Instant now = platforms_.front()->clock().now();
  if (!started_) firstStep_ = now;
  started_ = true;
  runUntilNoneCan(now);
  for (Entry& entry : processes_) report(entry, now);
  for (Platform* platform : platforms_) {
    platform->tryBeginFrame();  // Takes what is there; platforms step when no other can, satisfied or not.
    if (!platform->stopped()) platform->actuate();
  }
  if (options_.advance) options_.advance();
  for (Platform* platform : platforms_) {
    if (!platform->stopped()) platform->runFrame();
  }
}

void LockstepExecutor::runUntilNoneCan(Instant now) {
  for (bool ran = true; ran;) {
    ran = false;
    for (Entry& entry : processes_) {
      if (entry.everRan && entry.lastRun == now) continue;
      if (!entry.process->tryBeginFrame()) continue;
      entry.process->runFrame();
      entry.lastRun = now;
      entry.everRan = true;
      entry.reported = false;
      ran = true;
    }
  }
}

void LockstepExecutor::report(Entry& entry, Instant now) {
  if (entry.process->stopped()) {
    if (!entry.failureReported && !entry.process->failure().empty() && options_.onFailed) {
      options_.onFailed(*entry.process);
    }
    entry.failureReported = true;
    return;
  }
  const Instant since = entry.everRan ? entry.lastRun : firstStep_;
  if (entry.reported || now - since <= options_.starvation + entry.process->period()) return;
  entry.reported = true;
  if (options_.onStarved) options_.onStarved(*entry.process, entry.process->waitsFor());
}

}  // namespace robotlink
