// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace robotlink {

/// Whether what a stream says holds until it is told anew, however long ago that was and even if the
/// platform's clock was set back: tables, parameters, colour tables, set-ups of programs, and the scene.
/// Whoever begins in the middle (a log file, a cut, a view after a jump) needs the newest of each.
/// `type` is the full name of the messages' type.
bool holdsUntilToldAnew(std::string_view path, std::string_view type);
bool holdsUntilToldAnew(const StreamMessage& message);

/// The newest message of each stream and process that holds until told anew. Keeps copies, so that a table
/// does not keep the debug queue alive in which it came. Streams that somebody makes up are not taken past a
/// limit. One thread at a time.
class HeldMessages {
 public:
  static constexpr std::size_t kMaxStreams = 10'000;

  /// Takes a message if it is one that holds. False: it was not taken.
  bool take(const StreamMessage& message);
  /// Nothing that a robot told holds any more: its program starts anew.
  void forget(const std::string& robot);
  void clear() { messages_.clear(); }
  /// By path.
  std::vector<StreamMessage> all() const;

 private:
  std::map<std::pair<std::string, std::string>, StreamMessage> messages_;  // by path and process
};

}  // namespace robotlink
