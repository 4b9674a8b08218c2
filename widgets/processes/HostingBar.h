// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QPlainTextEdit;
class QToolButton;

namespace robotcontrol {
class HostingStatus;
class HostProgram;
}  // namespace robotcontrol

namespace widgets {

/// A bar that shows where a robot's program runs and, if it has ended or does not answer, what happened and
/// how it can be started again. GUI thread.
class HostingBar final : public QWidget {
  Q_OBJECT
 public:
  enum class Robots { kThis, kAll };

  explicit HostingBar(QWidget* parent);
  /// Null hides the bar: it is not known where the program runs.
  void setStatus(const robotcontrol::HostingStatus* status);

 Q_SIGNALS:
  /// The user wants a program to be moved or started again.
  void chosen(const robotcontrol::HostProgram& choice, Robots robots);

 private:
  void createActions();
  void choose(bool own, Robots robots);
  void chooseExecutor(bool threads);

  QLabel* text_ = nullptr;
  QPlainTextEdit* stack_ = nullptr;
  QAction* own_ = nullptr;
  QAction* threads_ = nullptr;
  QAction* allOwn_ = nullptr;
  QAction* allInside_ = nullptr;
  QAction* startAgain_ = nullptr;
};

}  // namespace widgets
