// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <csignal>
#include <map>

namespace app {

/// SIGINT, SIGTERM and SIGHUP as a Qt signal: a program that is stopped from outside closes properly, with
/// its recording complete and its window saved. A second signal of the same kind terminates it at once;
/// signals that were ignored at the start (nohup) stay ignored. Polls every 0.1 s, since a signal handler may
/// do next to nothing. One object at a time; GUI thread.
class QuitSignals : public QObject {
  Q_OBJECT
 public:
  /// Handles the signals until it is destroyed; then they have the effect that they had before.
  explicit QuitSignals(QObject* parent = nullptr);
  ~QuitSignals() override;

 Q_SIGNALS:
  /// Emitted once, after the first signal.
  void received();

 protected:
  /// Checks whether a signal has arrived.
  void timerEvent(QTimerEvent* event) override;

 private:
  /// The previous handlers, by signal.
  std::map<int, struct sigaction> before_;
};

}  // namespace app
