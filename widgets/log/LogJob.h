// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace widgets {

/// Something long that is done to a log (cut, exported, repaired), in a thread of its own. The destructor
/// gives it up and waits until it ended. The other functions: one thread, that of the GUI.
class LogJob {
 public:
  struct Outcome {
    bool done = false;  ///< else it failed
    bool cancelled = false;
    QString text;               ///< what was done, or why not
    std::filesystem::path log;  ///< a new log that can be opened; empty: there is none
  };
  /// The share done; false: give up.
  using Progress = std::function<bool(double)>;
  using Work = std::function<Outcome(const Progress&)>;

  LogJob(QString title, Work work);
  ~LogJob();
  LogJob(const LogJob&) = delete;
  LogJob& operator=(const LogJob&) = delete;

  const QString& title() const { return title_; }
  double share() const { return share_; }
  void cancel() { cancelled_ = true; }
  /// Once it ended.
  std::optional<Outcome> outcome();

 private:
  const QString title_;
  std::atomic<double> share_{0};
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;  // protects outcome_
  std::optional<Outcome> outcome_;
  std::thread thread_;
};

}  // namespace widgets
