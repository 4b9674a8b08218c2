// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace robotlink {

/// Whether a message of this path and type is latched: it stays valid until the next one of its stream,
/// however old it is and even if the platform's clock was set back. Latched are tables, parameters, color
/// tables, program set-ups, the map and the scene. A reader that begins in the middle (a log file, a cut, a
/// view after a jump) needs the newest of each. `type` is the full name of the message type.
bool isLatched(std::string_view path, std::string_view type);
bool isLatched(const StreamMessage& message);

/// A cache of the latched messages: the newest of each stream and process. Streams beyond kMaxStreams are
/// ignored, in case a robot makes up paths. One thread at a time.
class LatchedMessages {
 public:
  static constexpr std::size_t kMaxStreams = 10'000;

  /// Stores a message if it is latched. Returns false if it is not.
  bool take(const StreamMessage& message);
  /// Drops the messages of a robot, whose program is restarted.
  void forget(const std::string& robot);
  void clear() { messages_.clear(); }
  /// Returns the messages sorted by path, then process.
  std::vector<StreamMessage> all() const;

 private:
  /// Key: path and process.
  std::map<std::pair<std::string, std::string>, StreamMessage> messages_;
};

}  // namespace robotlink
