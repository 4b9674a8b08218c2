// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QObject>
#include <QString>
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
  /// Stalls that are longer than this are counted.
  static constexpr std::chrono::milliseconds kLimit{50};

  /// Begins to measure; shows nothing without a bar.
  StallWatch(QObject* parent, QStatusBar* bar);

  /// Whether the status bar is to show stalls.
  static bool isWanted();

  /// The stalls measured since the last reset.
  struct Stalls {
    std::uint64_t count = 0;  ///< of those longer than kLimit, in wall time
    /// The longest busy time: by the wall, and by the processor of this thread, which others that use the
    /// machine prolong less.
    std::chrono::microseconds longest{0}, longestCpu{0};
    /// The event that took most of the longest time of the processor: its receiver, its type, its time, and
    /// how many events there were in all; and how many pages of memory were touched for the first time, each
    /// of which may take longer than a virtual machine shows.
    QString cause;
    bool operator==(const Stalls&) const = default;
  };
  const Stalls& stalls() const { return stalls_; }
  void reset();

 protected:
  /// Notes which event is delivered, and the first one after a wait; filters nothing.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Moment {
    std::chrono::steady_clock::time_point wall;
    std::chrono::nanoseconds cpu;
    std::int64_t pageFaults = 0;
  };
  /// An event that is or was delivered. Those within it, which are sent at once, count on their own.
  struct Delivery {
    const char* receiver = "";  ///< its class, which lives as long as the program
    QString name;               ///< of the receiver
    QEvent::Type type = QEvent::None;
    std::chrono::nanoseconds cpu{0};

    QString describe() const;
  };
  static Moment now();
  void begin();
  void end();
  void endDelivery(const Moment& moment);
  void show();

  std::optional<Moment> begun_;
  Moment deliveryBegun_;
  Delivery delivery_, longestDelivery_;
  int deliveries_ = 0;
  Stalls stalls_, shown_;
  QLabel* label_ = nullptr;
  QString toolTip_;
};

}  // namespace app
