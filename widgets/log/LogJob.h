// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>

#include "robotlink/base/Worker.h"

namespace widgets {

/// A long operation on a log (cutting, exporting, repairing) in a thread of its own. Called by one thread,
/// that of the GUI. The destructor cancels the operation and waits for its end.
class LogJob {
 public:
  /// The outcome of the operation.
  struct Outcome {
    /// Whether it succeeded.
    bool done = false;
    /// Whether it failed because it was canceled.
    bool canceled = false;
    /// The result, or the reason for the failure; for the user.
    QString text;
    /// A new log that can be opened; empty: none.
    std::filesystem::path log;
  };
  /// Reports the progress, 0 to 1. False: the operation must end soon.
  using Progress = std::function<bool(double)>;
  /// The operation; called in the job's thread.
  using Work = std::function<Outcome(const Progress&)>;

  /// Starts at once. `title` is shown during the work.
  LogJob(QString title, Work work);

  const QString& title() const { return title_; }
  /// Progress, 0 to 1.
  double share() const { return share_; }
  /// Asks the operation to end; it does at its next report of progress.
  void cancel() { worker_.cancel(); }
  /// The outcome, once, after the operation has ended.
  std::optional<Outcome> takeOutcome() { return worker_.take(); }

 private:
  const QString title_;
  /// Written by the thread.
  std::atomic<double> share_{0};
  robotlink::Worker<Work, Outcome> worker_;
};

}  // namespace widgets
