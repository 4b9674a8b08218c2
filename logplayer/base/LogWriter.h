// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "logplayer/mcap/write/Writer.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Writes messages of streams into an MCAP file: one channel for each stream and publishing process, whose
/// schema is the message's type with all its dependencies (a FileDescriptorSet). A channel holds messages of
/// one type; a stream that changes its type gets another channel.
///
/// The layout of such a file is described in logplayer/LOGS.md. One thread at a time.
class LogWriter {
 public:
  /// The file must not exist.
  static robotlink::Result<std::unique_ptr<LogWriter>> create(const std::filesystem::path& file,
                                                              mcap::Writer::Options options);
  ~LogWriter();

  /// Writes a group of messages, usually a frame, that must be in the file completely or not at all. Fails
  /// with the first I/O error, and from then on.
  robotlink::Result<void> write(const std::vector<robotlink::StreamMessage>& frame);
  /// The container, for attachments, metadata, flush() and close().
  mcap::Writer& container();

 private:
  struct Implementation;
  explicit LogWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
