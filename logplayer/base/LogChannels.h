// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/mcap/read/Reader.h"
#include "robotlink/decoding/MessageType.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// The channels of a log file as parts of streams: which process published them, in which frames, and up to
/// which time its frames are complete. Uses the reader, which must outlive this object; like the reader, for
/// one thread at a time.
class LogChannels {
 public:
  /// Reads first and last FrameInfo of each process, and one message of each JSON channel without a schema.
  explicit LogChannels(mcap::Reader& reader);

  /// The channels of a stream; empty if there is no such stream.
  const std::vector<std::uint16_t>& of(const std::string& path) const;
  /// All streams with their channels, keyed by path. Channels without messages are left out.
  const std::map<std::string, std::vector<std::uint16_t>>& streams() const { return streams_; }
  /// Path and type of a channel, which must exist.
  const std::string& path(std::uint16_t channel) const { return states_.at(channel).path; }
  const robotlink::MessageType& type(std::uint16_t channel) const { return states_.at(channel).type; }
  /// The names of the robots: the first parts of paths on which a process, or a type of this program, was
  /// published. Not every first part of a path is a robot.
  std::set<std::string> robots() const;

  /// Whether a message belongs to a frame that was not written completely.
  bool hidden(const mcap::MessagePosition& position) const {
    return position.time > states_.at(position.channelId).completeUntil;
  }
  /// The time up to which a channel can be shown; Instant::max() if it is complete, Instant::min() if the
  /// reader found it later, when a summary turned out not to fit its file.
  mcap::Instant completeUntil(std::uint16_t channel) const {
    const auto found = states_.find(channel);
    return found == states_.end() ? mcap::Instant::min() : found->second.completeUntil;
  }
  /// Whether some messages of a channel may be hidden.
  bool cutShort(std::uint16_t channel) const { return completeUntil(channel) != mcap::Instant::max(); }

  /// Reads and decodes a message; empty if that fails.
  std::optional<robotlink::StreamMessage> read(const mcap::MessagePosition& position);
  std::optional<robotlink::StreamMessage> read(const mcap::Message& message) const;

 private:
  /// The state of a channel.
  struct State {
    std::string path;
    /// The process that published it; empty if unknown.
    std::string process;
    robotlink::MessageType type;
    mcap::Instant completeUntil = mcap::Instant::max();
    /// Number of the first frame of the process; the channel stores only the lower 32 bits of frame numbers.
    std::uint64_t firstFrame = 0;
  };
  /// First frame number and last FrameInfo time of a process that publishes frames.
  struct Frames {
    std::uint64_t first = 0;
    mcap::Instant last;
  };
  /// The bytes of the first message of a channel; empty if there is none.
  std::string firstOf(std::uint16_t channel);
  /// Sets State::firstFrame and State::completeUntil.
  void findFrames();
  /// `channel`: one that holds the FrameInfos of a process.
  std::optional<Frames> framesOf(std::uint16_t channel);

  mcap::Reader& reader_;
  std::map<std::uint16_t, State> states_;
  std::map<std::string, std::vector<std::uint16_t>> streams_;
};

/// Restores a 64-bit frame number from its lower 32 bits: the number nearest to `near`. 0, which means no
/// frame, stays 0 if `near` is small.
std::uint64_t widenFrame(std::uint32_t lower, std::uint64_t near);

}  // namespace logplayer
