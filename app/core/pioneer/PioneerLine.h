// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "robotlink/base/BoundedQueue.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {
class ByteStream;
}

namespace app {

/// The line to a real robot: opened, read and written in a thread of its own. When it is opened is for its
/// owner to say.
///
/// Any thread may call; none of the functions waits, but for the destructor, while a line is being opened.
/// Memory is bounded: what nobody takes is dropped, and so is what the robot does not take. The clock must
/// outlive it.
class PioneerLine {
 public:
  using Bytes = std::vector<std::uint8_t>;
  struct Opened {};
  struct Lost {
    robotlink::Error why;
  };
  /// In their order, each with when it came.
  struct Event {
    std::variant<Opened, Bytes, Lost> what;
    robotlink::Instant time;
  };

  PioneerLine(std::string url, const robotlink::Clock& clock);
  /// Sends what still waits, for a short time.
  ~PioneerLine();
  PioneerLine(const PioneerLine&) = delete;
  PioneerLine& operator=(const PioneerLine&) = delete;

  const std::string& url() const { return url_; }
  std::vector<Event> take() { return events_.drain(); }
  /// Bytes for the robot; dropped while the line is not open.
  void send(Bytes bytes);
  /// Opens it, if it is not open; an Opened or a Lost comes of it.
  void open();
  /// Closes it, after what waits was sent. No event comes of it.
  void close();

 private:
  void run();
  void serve(robotlink::arcos::ByteStream& stream);
  bool writeWaiting(robotlink::arcos::ByteStream& stream);
  void lose(const robotlink::Error& why);
  void report(std::variant<Opened, Bytes, Lost> what);
  bool waitUntilWanted();
  bool wanted();

  const std::string url_;
  const robotlink::Clock& clock_;
  robotlink::BoundedQueue<Event> events_;
  robotlink::BoundedQueue<Bytes> outgoing_;
  std::atomic<bool> open_{false};
  std::mutex mutex_;  // protects wanted_ and quit_
  std::condition_variable wakeUp_;
  bool wanted_ = false, quit_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace app
