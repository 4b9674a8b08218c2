// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/base/Progress.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/HistoryArchive.h"

namespace logplayer {

/// A source of messages in order of time: a log file, or what the history of live robots has
/// on disk. One thread at a time.
class MessageSource {
 public:
  /// Iterates over messages of some streams.
  class Cursor {
   public:
    virtual ~Cursor() = default;
    /// Time of the message that next() will return; empty at the end.
    virtual std::optional<robotlink::Instant> nextTime() = 0;
    /// Empty at the end. What cannot be read is left out.
    virtual std::optional<robotlink::StreamMessage> next() = 0;
  };

  virtual ~MessageSource() = default;
  /// Called first. Fails if nothing can be read, or with "log.given-up" if the progress callback returns
  /// false.
  virtual robotlink::Result<void> open(const Progress& progress) = 0;
  /// The paths of all streams.
  virtual std::vector<std::string> streams() const = 0;
  /// The stretch of time of its messages.
  virtual robotlink::Stretch stretch() const = 0;
  /// The messages of these streams, at least one, that are not earlier than `from`. The source must outlive
  /// the cursor.
  virtual std::unique_ptr<Cursor> read(const std::vector<std::string>& streams, robotlink::Instant from) = 0;
};

/// The messages of a log file.
std::unique_ptr<MessageSource> logSource(std::filesystem::path file);

/// The messages that an archive has; files that were removed meanwhile are left out. Of each stream one file
/// is open at a time.
std::unique_ptr<MessageSource> historySource(std::vector<robotlink::HistoryArchive::Piece> pieces);

}  // namespace logplayer
