// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "logplayer/MessageChange.h"
#include "logplayer/MessageType.h"
#include "logplayer/mcap/Reader.h"
#include "logplayer/mcap/Writer.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Copies messages of one log into another, with their channels and schemas when they are first needed. Times
/// are moved, robots renamed, in messages, too; what need not be changed is copied as the bytes that it is.
/// Both logs must outlive it. One thread.
class MessageCopier {
 public:
  MessageCopier(const mcap::Reader& from, mcap::Writer& to, robotlink::Duration offset, MessageChange change)
      : from_(from), to_(to), offset_(offset), change_(std::move(change)) {}

  /// `message`: with the channel and the times of the log that it is from.
  robotlink::Result<void> copy(const mcap::Message& message);
  /// Messages that should have been changed, but make no sense by their schemas; they were copied as they
  /// are.
  std::uint64_t unchanged() const { return unchanged_; }
  /// Topics whose messages would have been changed, were they Protobuf; between commas.
  const std::string& foreign() const { return foreign_; }

 private:
  struct Target {
    std::uint16_t channel = 0;
    std::optional<MessageType> type;  ///< only where messages may have to be changed
  };
  robotlink::Result<const Target*> targetOf(std::uint16_t channel);

  const mcap::Reader& from_;
  mcap::Writer& to_;
  robotlink::Duration offset_;
  MessageChange change_;
  std::map<std::uint16_t, Target> targets_;  // by channel
  std::uint64_t unchanged_ = 0;
  std::string foreign_;
};

}  // namespace logplayer
