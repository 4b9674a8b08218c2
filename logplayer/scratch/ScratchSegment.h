// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/file/LogFile.h"
#include "robotlink/session/HistoryArchive.h"

namespace logplayer {

/// A part of a scratch log: the messages that left a session's history together. They are in memory until
/// they were written to a log file of their own. One thread at a time, except for constant data: times(),
/// shares().
class ScratchSegment {
 public:
  /// Times of the first and the last message of a stream.
  using Times = robotlink::Stretch;

  explicit ScratchSegment(std::vector<robotlink::StreamMessage> messages);

  /// The messages of the segment; null after they were written to disk.
  const std::shared_ptr<const std::vector<robotlink::StreamMessage>>& messages() const { return messages_; }
  /// Keyed by the paths of the streams.
  const std::map<std::string, Times>& times() const { return times_; }
  /// The memory that each stream's messages took.
  const std::map<std::string, std::uint64_t>& shares() const { return shares_; }
  /// The time of its earliest message, and of its last one.
  const robotlink::Stretch& stretch() const { return stretch_; }

  /// Writes the messages to a new file and releases them. Fails, and has lost them, if that is impossible.
  robotlink::Result<void> write(const std::filesystem::path& file);
  /// Empty before it was written.
  const std::filesystem::path& file() const { return file_; }

  /// The newest message of a stream not later than `time`; empty if there is none.
  std::optional<robotlink::StreamMessage> latest(const std::string& stream, robotlink::Instant time);
  /// Appends all messages later than `from` and not later than `to`; in order of time within each stream.
  robotlink::Result<void> read(robotlink::Instant from, robotlink::Instant to,
                               std::vector<robotlink::StreamMessage>& out);
  /// Closes the file until it is read again.
  void close() { log_.reset(); }

 private:
  robotlink::Result<void> open();

  std::shared_ptr<const std::vector<robotlink::StreamMessage>> messages_;
  std::map<std::string, Times> times_;
  std::map<std::string, std::uint64_t> shares_;
  robotlink::Stretch stretch_;
  std::filesystem::path file_;
  /// Null unless it was read lately.
  std::shared_ptr<LogFile> log_;
};

}  // namespace logplayer
