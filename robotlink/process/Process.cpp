// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Process.h"

#include <algorithm>
#include <exception>

namespace robotlink {

Process::Process(std::string name, const Clock& clock) : EndOwner(std::move(name)), clock_(clock) {}

Process::~Process() = default;

bool Process::satisfied() const {
  return std::all_of(receivers().begin(), receivers().end(), [](const auto* r) { return r->satisfied(); }) &&
         std::all_of(senders().begin(), senders().end(), [](const auto* s) { return s->satisfied(); });
}

std::optional<Instant> Process::due() const {
  return period_ > Duration::zero() ? due_ : std::nullopt;
}

Duration Process::untilDue() const {
  const auto dueAt = due();
  const Instant now = clock_.now();
  // If the clock was set back (a simulation was reset), periods start afresh.
  return !dueAt || now < frameTime_ ? Duration::zero() : *dueAt - now;
}

bool Process::tryBeginFrame() {
  if (stopped()) return false;
  for (AnyReceiver* receiver : receivers()) receiver->take();
  return untilDue() <= Duration::zero() && satisfied();
}

void Process::startPeriod(Instant now) {
  if (period_ <= Duration::zero()) return;
  if (now < frameTime_) due_.reset();
  // Counted from the due time rather than from now, so that a late frame does not delay all later ones,
  // unless a whole period was lost.
  due_ = due_.value_or(now) + period_;
  if (*due_ <= now) due_ = now + period_;
}

void Process::runFrame() {
  const Instant now = clock_.now();
  startPeriod(now);
  frameTime_ = now;
  for (AnyReceiver* receiver : receivers()) receiver->beginFrame();
  // Phase 3 needs no code: links deliver what they keep when the receivers take.
  if (guard([this] { execute(); })) frames_.fetch_add(1, std::memory_order_relaxed);
}

bool Process::guard(const std::function<void()>& call) {
  std::string thrown;
  try {
    call();
    return true;
  } catch (const std::exception& exception) {
    thrown = exception.what();
  } catch (...) {
    thrown = "an exception of unknown type";
  }
  {
    const std::lock_guard lock(mutex_);
    failure_ = thrown.empty() ? "an exception without a text" : thrown;
  }
  stop();
  return false;
}

bool Process::waitForFrame(std::chrono::milliseconds limit) {
  while (!stopped()) {
    if (tryBeginFrame()) return true;
    const Duration remaining = untilDue();
    const Duration wait =
        remaining > Duration::zero() ? std::min<Duration>(remaining, limit) : Duration(limit);
    std::unique_lock lock(mutex_);
    wakeUp_.wait_for(lock, wait, [this] { return woken_; });
    woken_ = false;
  }
  return false;
}

void Process::wake() {
  {
    const std::lock_guard lock(mutex_);
    woken_ = true;
  }
  wakeUp_.notify_one();
}

void Process::stop() {
  // Once: what belongs to others may be gone when the process itself ends.
  if (!stopped_.exchange(true, std::memory_order_acq_rel)) {
    for (AnyReceiver* receiver : receivers()) receiver->close();
    for (AnySender* sender : senders()) sender->close();
  }
  wake();
}

std::string Process::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

std::string Process::waitsFor() const {
  for (const AnyReceiver* receiver : receivers()) {
    if (!receiver->satisfied()) return receiver->waitsFor();
  }
  for (const AnySender* sender : senders()) {
    if (!sender->satisfied()) return "its package " + sender->package() + " to be taken";
  }
  return due() ? "its period" : "nothing";
}

}  // namespace robotlink
