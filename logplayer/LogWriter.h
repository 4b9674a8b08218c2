// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "logplayer/mcap/Writer.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Writes messages of streams into a log file: an MCAP file with one channel for each stream and process that
/// told it, whose schema is the message's type with all that it needs (a FileDescriptorSet). What is written
/// in one channel is of one type; when a stream changes its type it gets another channel.
///
/// The layout of such a file is described in logplayer/LOGS.md. One thread at a time.
class LogWriter {
 public:
  static robotlink::Result<std::unique_ptr<LogWriter>> create(const std::filesystem::path& file,
                                                              mcap::Writer::Options options);
  ~LogWriter();

  /// A frame, or anything else that is in the file as a whole or not at all.
  robotlink::Result<void> write(const std::vector<robotlink::StreamMessage>& frame);
  /// The container, for attachments, metadata, flush and close.
  mcap::Writer& container();

 private:
  struct Implementation;
  explicit LogWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
