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

/// One job with logs at a time: how far it is, with a button that cancels it, then how it ended. Hidden
/// without one.
class LogJobBar final : public QWidget {
  Q_OBJECT
 public:
  explicit LogJobBar(QWidget* parent = nullptr);
  ~LogJobBar() override;

  bool busy() const { return job_ != nullptr; }
  /// Nothing if another one is still at work.
  void start(const QString& title, LogJob::Work work);
  void tick();

 Q_SIGNALS:
  /// A person wants to see the log that was made.
  void openWanted(const QString& file);
  void ended();

 private:
  void showOutcome(const LogJob::Outcome& outcome);

  std::unique_ptr<LogJob> job_;
  QLabel* text_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QToolButton* open_;
  QToolButton* dismiss_;
  std::filesystem::path made_;
};

/// Says what of a log could not be read, and offers to repair it. Hidden if all logs are whole or it was
/// dismissed.
class LogDamageBar final : public QWidget {
  Q_OBJECT
 public:
  struct Damage {
    std::string log;  ///< its path
    QString text;
    bool canRepair = true;
    bool operator==(const Damage&) const = default;
  };
  explicit LogDamageBar(QWidget* parent = nullptr);
  /// The first that was not dismissed is shown.
  void setDamages(std::vector<Damage> damages);
  void setBusy(bool busy);

 Q_SIGNALS:
  void repairWanted(const QString& log);

 private:
  void showFirst();

  std::vector<Damage> damages_;
  std::set<std::string> dismissed_;  // paths
  Damage shown_;
  QLabel* text_;
  QToolButton* repair_;
};

}  // namespace widgets
