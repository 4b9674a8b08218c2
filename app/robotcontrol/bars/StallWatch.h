// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <chrono>
#include <cstdint>
#include <optional>

class QLabel;
class QStatusBar;

namespace app {

/// Measures how long the event loop of the GUI's thread is busy without looking for new events, during which
/// the window does not answer. In development builds (with assertions), or with the environment variable
/// ROBOTCONTROL_STALLS, the status bar shows it. GUI thread; loops within loops, of dialogs, are measured on
/// their own.
class StallWatch final : public QObject {
  Q_OBJECT
 public:
  /// What is longer is noticed.
  static constexpr std::chrono::milliseconds kLimit{50};

  /// Begins to measure; shows nothing without a bar.
  StallWatch(QObject* parent, QStatusBar* bar);

  /// Whether the status bar is to show stalls.
  static bool isWanted();

  /// What was measured since the last reset.
  struct Stalls {
    std::uint64_t count = 0;  ///< of those longer than kLimit, in wall time
    /// The longest busy time: by the wall, and by the processor of this thread, which others that use the
    /// machine prolong less.
    std::chrono::microseconds longest{0}, longestCpu{0};
    bool operator==(const Stalls&) const = default;
  };
  const Stalls& stalls() const { return stalls_; }
  void reset();

 protected:
  /// Notes the first event after a wait; filters nothing.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Moment {
    std::chrono::steady_clock::time_point wall;
    std::chrono::nanoseconds cpu;
  };
  static Moment now();
  void begin();
  void end();
  void show();

  std::optional<Moment> begun_;
  Stalls stalls_, shown_;
  QLabel* label_ = nullptr;
};

}  // namespace app
