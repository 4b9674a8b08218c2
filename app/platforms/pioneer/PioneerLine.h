// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/BoundedQueue.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/threads/PacedThread.h"

namespace robotlink::arcos {
class ByteStream;
}

namespace app {

/// The line to a real robot, TCP or serial: opened, read and written in a thread of its own. The owner
/// decides when it is opened.
///
/// Any thread may call. Only the destructor may block, while the line is being opened (up to 3 s). Memory is
/// bounded: received data that is not taken is dropped, and so is what the robot does not accept. The clock
/// must outlive it.
class PioneerLine {
 public:
  using Bytes = std::vector<std::uint8_t>;
  /// The line is open.
  struct Opened {};
  /// The line could not be opened, or broke.
  struct Lost {
    robotlink::Error why;
  };
  /// An event on the line, and its time.
  struct Event {
    std::variant<Opened, Bytes, Lost> what;
    robotlink::Instant time;
  };

  /// `url` as arcos::parseUrl() reads it; the line stays closed until open().
  PioneerLine(std::string url, const robotlink::Clock& clock);
  /// Sends what is waiting, then closes the line.
  ~PioneerLine();
  PioneerLine(const PioneerLine&) = delete;
  PioneerLine& operator=(const PioneerLine&) = delete;

  /// Removes and returns the events so far, in order.
  std::vector<Event> take() { return events_.drain(); }
  /// Enqueues bytes for the robot; drops them while the line is not open.
  void send(Bytes bytes);
  /// Like send(), but sends even if the robot has not taken what waits before: for STOP.
  void sendUrgent(Bytes bytes);
  /// Opens the line if it is not open. Either an Opened or a Lost follows.
  void open();
  /// The same at another URL, such as one with another speed; the line must be idle.
  void open(std::string url);
  /// Closes the line after sending what is waiting. No event follows once it is idle.
  void close();
  /// Whether the line is closed and not being opened or closed.
  bool isIdle();

 private:
  /// When step() is to be called: at once, if the line is wanted.
  std::optional<robotlink::PacedThread::Clock::time_point> due();
  /// Opens the line and serves it, if it is still wanted.
  void step();
  /// Reads and writes until the line breaks or is to be closed.
  void serve(robotlink::arcos::ByteStream& stream);
  /// Sends the enqueued bytes. Returns false if the line broke.
  bool writeWaiting(robotlink::arcos::ByteStream& stream);
  /// Stops wanting the line and reports that it was lost.
  void lose(const robotlink::Error& why);
  /// Enqueues an event with the current time.
  void report(std::variant<Opened, Bytes, Lost> what);
  /// Begins to use the line, and returns its URL; empty if it is not wanted.
  std::optional<std::string> beginUse();
  /// Whether the line should be open.
  bool wanted();

  const robotlink::Clock& clock_;
  robotlink::BoundedQueue<Event> events_;
  robotlink::BoundedQueue<Bytes> outgoing_;
  /// Whether send() accepts bytes.
  std::atomic<bool> open_{false};
  /// Protects url_, wanted_ and busy_.
  std::mutex mutex_;
  std::string url_;
  /// busy_: the thread uses the line.
  bool wanted_ = false, busy_ = false;
  /// The last member, since the thread uses the others.
  robotlink::PacedThread thread_;
};

}  // namespace app
