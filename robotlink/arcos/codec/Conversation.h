// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// A recorded conversation of a client and a robot: the contents of a `.wire` file. A plain value.
///
/// The file is text with one event a line (ARCOS.md describes the format):
///
///     === new connection
///         73.9 C>S id=0(0x00) len=3 ck=ok fafb03000000
///       4625.1 client closed
struct Conversation {
  /// The type of an event; kClosed means that the client closed the line.
  enum class Kind { kNewConnection, kPacket, kClosed };
  /// An event with its time.
  struct Event {
    Kind kind = Kind::kPacket;
    /// The time since the connection began; files have a resolution of 0.1 ms. 0 for a new connection.
    Duration at{};
    /// The direction of a packet.
    Direction direction = Direction::kFromClient;
    /// The bytes of a packet's frame, including damaged ones, as they were on the line.
    Bytes bytes;
    bool operator==(const Event&) const = default;
  };
  std::vector<Event> events;
  bool operator==(const Conversation&) const = default;
};

/// Files of this size or larger are refused without being read.
inline constexpr std::size_t kMaxConversationBytes = 256U << 20U;

/// Parses a conversation. Empty lines and lines that begin with # are skipped. Fails at the first wrong line
/// with file and line; the description of the bytes in a line must match them. Ids begin with "arcos.".
Result<Conversation> readConversation(std::string_view text, const std::string& path);
/// Parses the conversation in a file; fails also if that cannot be read.
Result<Conversation> readConversationFile(const std::filesystem::path& file);

/// The line of an event, with its line end, for recording while a conversation is in progress.
std::string writeEvent(const Conversation::Event& event);
/// The text of a whole conversation.
std::string writeConversation(const Conversation& conversation);

}  // namespace robotlink::arcos
