// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotlink {

/// One message of a stream.
struct StreamMessage {
  std::string path;  ///< "red1/camera/image"
  Instant time;      ///< of the robot's platform
  PackagePtr value;
};

/// The bounded history of all streams of a session. A message that is kept is never copied: views share it. The newest message
/// of a stream is always kept, so that what changes rarely (tables, transforms) is never lost.
///
/// Used by one thread, the GUI's: producers hand messages to Session. Messages of one stream come in order of time; one that
/// goes back in time (the simulation was reset) forgets what is later in all streams of that session.
class StreamStore {
 public:
  struct Limits {
    Duration age = std::chrono::seconds(60);
    std::size_t bytes = 512U << 20U;
  };
  struct Stream {
    std::string path;
    std::string type;  ///< full name of the message type
    std::deque<StreamMessage> messages;  ///< oldest first
    std::uint64_t count = 0;  ///< ever received
    std::uint64_t bytes = 0;  ///< kept
    double rate = 0;  ///< Hz, over the last second of the platform's time
  };

  explicit StreamStore(Limits limits);
  void add(StreamMessage message);
  void clear();

  /// Null if it has never been seen.
  const Stream* find(const std::string& path) const;
  /// All streams whose path starts with `prefix`, by path.
  std::vector<const Stream*> streams(const std::string& prefix = {}) const;
  /// The newest message not later than `time`; null if there is none.
  const StreamMessage* latest(const std::string& path, Instant time) const;
  /// The same as its type; null if it is of another.
  template <typename T>
  const T* latestAs(const std::string& path, Instant time) const {
    const StreamMessage* message = latest(path, time);
    return message ? dynamic_cast<const T*>(message->value.get()) : nullptr;
  }
  /// Grows with every change of the list of streams, so that a view need not compare lists.
  std::uint64_t listVersion() const { return listVersion_; }
  std::size_t bytes() const { return bytes_; }
  Instant newest() const { return newest_; }
  Instant oldest() const;

 private:
  void forgetAfter(Instant time);
  void forgetOld();

  Limits limits_;
  std::map<std::string, Stream> streams_;
  std::size_t bytes_ = 0;
  std::uint64_t listVersion_ = 0;
  Instant newest_;
};

}  // namespace robotlink
