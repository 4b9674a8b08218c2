// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/MessageType.h"
#include "logplayer/mcap/Reader.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// The channels of a log file as parts of streams: which process told them, in which frames, and up to when
/// its frames are complete. Asks the reader, and like it is for one thread at a time. The reader must outlive
/// it.
class LogChannels {
 public:
  explicit LogChannels(mcap::Reader& reader);

  /// The channels of a stream; empty if there is no such stream.
  const std::vector<std::uint16_t>& of(const std::string& path) const;
  /// Streams with their channels, by path. Channels without messages are not in it.
  const std::map<std::string, std::vector<std::uint16_t>>& streams() const { return streams_; }
  const std::string& path(std::uint16_t channel) const { return states_.at(channel).path; }
  const MessageType& type(std::uint16_t channel) const { return states_.at(channel).type; }
  /// Those that the log says to be robots: that have a program, processes or frames, not any first part of a
  /// path.
  std::set<std::string> robots() const;

  /// Whether a message belongs to a frame that was not written to its end.
  bool hidden(const mcap::MessagePosition& position) const {
    return position.time > states_.at(position.channelId).completeUntil;
  }
  /// What of a channel can be shown ends there.
  mcap::Instant completeUntil(std::uint16_t channel) const { return states_.at(channel).completeUntil; }
  /// Whether something of a channel is hidden.
  bool cutShort(std::uint16_t channel) const { return completeUntil(channel) != mcap::Instant::max(); }

  /// Null if it cannot be read.
  std::optional<robotlink::StreamMessage> read(const mcap::MessagePosition& position);
  std::optional<robotlink::StreamMessage> read(const mcap::Message& message) const;

 private:
  struct State {
    std::string path;
    std::string process;
    MessageType type;
    mcap::Instant completeUntil = mcap::Instant::max();
    std::uint64_t firstFrame = 0;  // of the process; tells the upper half of its frames' numbers
  };
  /// A process that told frames: its FrameInfos in the order of time.
  struct Frames {
    std::uint64_t first = 0;
    mcap::Instant last;
  };
  std::string firstOf(std::uint16_t channel);
  void findFrames();
  std::optional<Frames> framesOf(std::uint16_t channel);

  mcap::Reader& reader_;
  std::map<std::uint16_t, State> states_;
  std::map<std::string, std::vector<std::uint16_t>> streams_;
};

/// The number nearest to `near` that has these lower 32 bits. 0 stays 0.
std::uint64_t widenFrame(std::uint32_t lower, std::uint64_t near);

}  // namespace logplayer
