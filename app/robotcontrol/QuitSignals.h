// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace app {

/// SIGINT, SIGTERM and SIGHUP as a signal of Qt's: who stops the program from outside finds it closed
/// properly, with its recording complete and its window kept. A second one of the same kind ends it at once.
/// One at a time; GUI thread.
class QuitSignals : public QObject {
  Q_OBJECT
 public:
  explicit QuitSignals(QObject* parent = nullptr);
  ~QuitSignals() override;

 Q_SIGNALS:
  void received();

 protected:
  void timerEvent(QTimerEvent* event) override;
};

}  // namespace app
