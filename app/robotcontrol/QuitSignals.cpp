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

void setHandlers(void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  for (const int number : kSignals) {
    struct sigaction before = {};
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);  // keep signals that nohup ignores
  }
}

}  // namespace

QuitSignals::QuitSignals(QObject* parent) : QObject(parent) {
  wanted = false;
  // The handler is reset, so that a second signal has its default effect.
  setHandlers([](int) { wanted = true; }, static_cast<int>(SA_RESETHAND) | SA_RESTART);
  startTimer(kLookForSignalsEveryMs);
}

QuitSignals::~QuitSignals() {
  setHandlers(SIG_DFL, 0);
}

void QuitSignals::timerEvent(QTimerEvent* event) {
  if (!wanted) return;
  killTimer(event->timerId());
  Q_EMIT received();
}

}  // namespace app
