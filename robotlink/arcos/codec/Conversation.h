// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// What a client and a robot said to each other: a `.wire` file. A value.
///
/// The file is text, one event a line (ARCOS.md has the format):
///
///     === new connection
///         73.9 C>S id=0(0x00) len=3 ck=ok fafb03000000
///       4625.1 client closed
struct Conversation {
  enum class Kind { kNewConnection, kPacket, kClosed };
  struct Event {
    Kind kind = Kind::kPacket;
    Duration at{};  ///< since the connection began; files keep 0.1 ms; of a new connection 0
    Direction direction = Direction::kFromClient;  ///< of packets
    Bytes bytes;  ///< of packets, with their frame: as they went over the line, damaged ones too
    bool operator==(const Event&) const = default;
  };
  std::vector<Event> events;
  bool operator==(const Conversation&) const = default;
};

/// A file of at least this size is refused without being read.
inline constexpr std::size_t kMaximumConversationBytes = 256U << 20U;

/// Empty lines and those that begin with # are skipped. The first line that is wrong is the error, with file
/// and line: what it says of its bytes must be so. Ids begin with "arcos.".
Result<Conversation> readConversation(std::string_view text, const std::string& path);
Result<Conversation> readConversationFile(const std::filesystem::path& file);

/// The line of an event, with its end, so that a conversation can be recorded while it goes on.
std::string writeEvent(const Conversation::Event& event);
std::string writeConversation(const Conversation& conversation);

}  // namespace robotlink::arcos
