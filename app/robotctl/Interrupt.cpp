// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/Interrupt.h"

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "robotlink/base/UnfinishedFile.h"

namespace app {
namespace {

using WatchClock = std::chrono::steady_clock;

constexpr std::chrono::seconds kSame{
    1};  // signals within this time count as one: closing a terminal sends several
constexpr std::chrono::seconds kGrace{2};  // time for the first call of noted()

// Signals are a matter of the whole process, hence global variables.
std::atomic<int> caught{0};
std::atomic<int> guards{0};       // number of Interrupt objects
std::atomic<bool> heeded{false};  // whether noted() has returned true
std::atomic<bool> watching{false};
std::optional<std::thread> watcher;  // no robotlink::PacedThread: signals wake it

void noteBrokenPipe(int signal) {
  int none = 0;
  caught.compare_exchange_strong(none, signal);
}

bool isIgnored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t watchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!isIgnored(signal)) sigaddset(&signals, signal);
  }
  return signals;
}

/// Waits for one of these signals; returns whether one arrived before `end`.
bool comesUntil(WatchClock::time_point end, const sigset_t& signals) {
  const auto left = end - WatchClock::now();
  if (left <= left.zero()) return false;
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
  const timespec time{whole.count(), std::chrono::nanoseconds(left - whole).count()};
  return ::sigtimedwait(&signals, nullptr, &time) > 0;
}

/// Called after the first signal. Returns if the program ends by itself; otherwise terminates it at a second
/// signal, or if nothing reacts to the first one.
void waitForTheEnd(const sigset_t& signals, int first) {
  const auto came = WatchClock::now();
  while (watching && comesUntil(came + kSame, signals)) {
  }
  const bool second = watching && comesUntil(came + kGrace, signals);
  int signal = 0;
  if (watching && !second && heeded) sigwait(&signals, &signal);
  if (watching) robotlink::endProgram(Interrupt::exitStatus(first));
}

void watch(sigset_t signals) {
  int signal = 0;
  sigwait(&signals, &signal);
  if (!watching) return;
  caught = signal;
  if (guards == 0) robotlink::endProgram(Interrupt::exitStatus(signal));
  waitForTheEnd(signals, signal);
}

}  // namespace

SignalWatch::SignalWatch() {
  struct sigaction pipe {};
  pipe.sa_handler = &noteBrokenPipe;
  pipe.sa_flags = SA_RESTART;
  if (!isIgnored(SIGPIPE)) ::sigaction(SIGPIPE, &pipe, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // then writing beyond the limit fails with an error, which is reported
  const sigset_t signals = watchedSignals();
  if (sigisemptyset(&signals) != 0) return;
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  watching = true;
  watcher.emplace(&watch, signals);
}

SignalWatch::~SignalWatch() {
  if (!watcher) return;
  watching = false;  // the signals below wake the thread, which then ends
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!isIgnored(signal)) ::pthread_kill(watcher->native_handle(), signal);
  }
  watcher->join();
  watcher.reset();
}

Interrupt::Interrupt() {
  ++guards;
}
Interrupt::~Interrupt() {
  --guards;
}

bool Interrupt::noted() {
  if (caught == 0) return false;
  heeded = true;
  return true;
}

int Interrupt::signal() {
  return caught;
}

}  // namespace app
