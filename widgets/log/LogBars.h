// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "widgets/log/LogJob.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace widgets {

/// Progress and outcome of one job on logs: a bar with a button that cancels it, then a sentence that says
/// how it ended. Hidden without a job. GUI thread.
class LogJobBar final : public QWidget {
  Q_OBJECT
 public:
  explicit LogJobBar(QWidget* parent = nullptr);
  /// Cancels the job and waits for its end.
  ~LogJobBar() override;

  bool busy() const { return job_ != nullptr; }
  /// Starts a job; ignored while another one is running.
  void start(const QString& title, LogJob::Work work);
  /// Shows the progress; call this once per tick.
  void tick();

 Q_SIGNALS:
  /// The user wants to open the log that the job has written.
  void openWanted(const QString& file);

 private:
  /// Replaces the progress by the outcome.
  void showOutcome(const LogJob::Outcome& outcome);

  /// Null: none is running.
  std::unique_ptr<LogJob> job_;
  QLabel* text_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QToolButton* open_;
  QToolButton* dismiss_;
  /// The log that the last job has written; empty: none.
  std::filesystem::path made_;
};

/// The damage report of a log, with a button that repairs it. Hidden if all logs are intact or their reports
/// were dismissed. GUI thread.
class LogDamageBar final : public QWidget {
  Q_OBJECT
 public:
  /// The damage report of one log.
  struct Damage {
    /// Path of the log.
    std::string log;
    QString text;
    /// Whether the file can be repaired; logs of other formats cannot.
    bool canRepair = true;
    bool operator==(const Damage&) const = default;
  };
  explicit LogDamageBar(QWidget* parent = nullptr);
  /// Shows the first report that was not dismissed.
  void setDamages(std::vector<Damage> damages);
  /// Disables the button while a job is running.
  void setBusy(bool busy);

 Q_SIGNALS:
  /// The user wants to repair a log (its path).
  void repairWanted(const QString& log);

 private:
  /// Shows the first report that was not dismissed, or hides the bar.
  void showFirst();

  std::vector<Damage> damages_;
  /// Paths of the logs whose reports were dismissed.
  std::set<std::string> dismissed_;
  /// The report that is shown.
  Damage shown_;
  QLabel* text_;
  QToolButton* repair_;
};

}  // namespace widgets
