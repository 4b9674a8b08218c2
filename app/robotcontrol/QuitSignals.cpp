// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/QuitSignals.h"

#include <QTimerEvent>
#include <atomic>
#include <csignal>

namespace app {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
constexpr int kLookForSignalsEveryMs = 100;

/// The only variable that the signal handler accesses.
std::atomic<bool> wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

QuitSignals::QuitSignals(QObject* parent) : QObject(parent) {
  wanted = false;
  struct sigaction action = {};
  action.sa_handler = [](int) { wanted = true; };
  // The handler is reset, so that a second signal has its default effect.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : kSignals) {
    struct sigaction before = {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;  // as nohup wants it
    sigaction(number, &action, nullptr);
    before_[number] = before;
  }
  startTimer(kLookForSignalsEveryMs);
}

QuitSignals::~QuitSignals() {
  for (const auto& [number, before] : before_) sigaction(number, &before, nullptr);
}

void QuitSignals::timerEvent(QTimerEvent* event) {
  if (!wanted) return;
  killTimer(event->timerId());
  Q_EMIT received();
}

}  // namespace app
