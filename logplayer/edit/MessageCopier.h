// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "logplayer/base/MessageChange.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/write/Writer.h"
#include "robotlink/base/Error.h"
#include "robotlink/decoding/MessageType.h"

namespace logplayer {

/// Copies messages from one log into another, together with their channels and schemas when they are first
/// needed. Moves times and renames robots, inside messages as well; messages that need no change are copied
/// byte by byte. Both logs must outlive this object. One thread.
class MessageCopier {
 public:
  /// `offset` is added to the times of messages, `change` is applied to their contents.
  MessageCopier(const mcap::Reader& from, mcap::Writer& to, robotlink::Duration offset, MessageChange change)
      : from_(from), to_(to), offset_(offset), change_(std::move(change)) {}

  /// Copies a message; channel id and times are those of the source. Fails if the target cannot be written.
  robotlink::Result<void> copy(const mcap::Message& message);
  /// Number of messages that should have been changed but could not be decoded; they were copied unchanged.
  std::uint64_t unchanged() const { return unchanged_; }
  /// Topics whose messages could not be changed because they are not Protobuf, separated by commas.
  const std::string& foreign() const { return foreign_; }

 private:
  /// A channel of the target log.
  struct Target {
    std::uint16_t channel = 0;
    /// Set only if messages of the channel may have to be changed.
    std::optional<robotlink::MessageType> type;
  };
  /// The target of a source channel, which is added to the target log at first use.
  robotlink::Result<const Target*> targetOf(std::uint16_t channel);

  const mcap::Reader& from_;
  mcap::Writer& to_;
  robotlink::Duration offset_;
  MessageChange change_;
  /// Keyed by source channel.
  std::map<std::uint16_t, Target> targets_;
  std::uint64_t unchanged_ = 0;
  std::string foreign_;
};

}  // namespace logplayer
