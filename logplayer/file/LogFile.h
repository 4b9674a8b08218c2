// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "logplayer/base/Progress.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

class ContainerFile;

/// A log file as streams of messages, read lazily. Types that this program does not know are built from the
/// schemas in the file; messages keep alive what they need.
///
/// Files of older formats (see LogImport.h) are first converted into a temporary file, which is removed at
/// the end, and are read-only. If the recorder was killed, incomplete frames at the end are hidden: a frame
/// is complete or absent.
///
/// Thread-safe: a mutex protects the reader, so that a call may wait for the disk access of another one.
class LogFile {
 public:
  using Progress = logplayer::Progress;
  /// How a file is opened.
  struct Options {
    /// Memory for decompressed chunks.
    std::size_t cacheBytes = 64U << 20U;
    /// For conversions and scans, which take long; may be empty.
    Progress progress;
  };
  /// A stream of a log, which may consist of several channels.
  struct Stream {
    std::string path;
    /// Name of the message type in the schema of the newest channel.
    std::string type;
    /// Encoding of the messages of the newest channel, as in the file: "protobuf", "json", "cdr".
    std::string encoding;
    /// Number of messages, without those of incomplete frames.
    std::uint64_t count = 0;
    /// Uncompressed size of the messages; 0 until countBytes().
    std::uint64_t bytes = 0;
    /// Number of messages in encodings that are not supported; they are delivered as bytes.
    std::uint64_t undecoded = 0;
    /// Times of the first and the last message.
    robotlink::Instant first, last;

    /// Whether at least some messages are decoded.
    bool isDecoded() const { return undecoded < count; }
    /// Whether its messages are decoded values of this type.
    bool holds(std::string_view typeName) const { return type == typeName && isDecoded(); }
  };
  /// Fails if the file cannot be read, contains nothing of MCAP, cannot be converted, or with "log.given-up"
  /// if the progress callback returns false. Anything else that is wrong is in damage().
  static robotlink::Result<std::shared_ptr<LogFile>> open(const std::filesystem::path& file,
                                                          const Options& options);
  /// Wraps a file that is already open: `reader` reads `container`.
  static std::shared_ptr<LogFile> of(const std::filesystem::path& file, ContainerFile container,
                                     std::unique_ptr<mcap::Reader> reader);
  ~LogFile();

  /// The file that was opened, not the converted copy.
  const std::filesystem::path& path() const;
  /// Whether bookmarks and attachments cannot be appended.
  bool readOnly() const;
  /// Sorted by path.
  const std::vector<Stream>& streams() const;
  /// Returns the streams with Stream::bytes set, which requires reading the whole file. Empty if canceled by
  /// the progress callback.
  std::vector<Stream> countBytes(const Progress& progress);
  /// The robots of the log, see LogChannels::robots().
  std::vector<std::string> robots() const;
  /// The times of the first and the last message that robots published, apart from latched ones, which may be
  /// older than the recording; equal if there is none.
  robotlink::Instant begin() const;
  robotlink::Instant end() const;
  /// Whether the file was closed properly.
  bool complete() const;
  /// Returns the damage found so far.
  std::vector<mcap::Damage> damage() const;
  /// Describes all damage, for the user; empty if the file is intact.
  std::string damageText() const;

  /// The newest message of a stream not later than `time`; empty if there is none. Unreadable messages are
  /// skipped and counted in damage().
  std::optional<robotlink::StreamMessage> latest(const std::string& stream, robotlink::Instant time);
  /// Time of the first message of a stream later than `time`.
  std::optional<robotlink::Instant> timeAfter(const std::string& stream, robotlink::Instant time);
  /// The times of all messages of a stream, sorted.
  std::vector<robotlink::Instant> times(const std::string& stream);

  /// Iterates over the messages of some streams (all if `streams` is empty) in order of time; messages with
  /// equal times in the order of the file. It keeps the file open. One thread; different cursors of a file
  /// may be used in different threads.
  class Cursor {
   public:
    Cursor(std::shared_ptr<LogFile> file, const std::vector<std::string>& streams);
    ~Cursor();
    Cursor(Cursor&&) noexcept;
    Cursor& operator=(Cursor&&) noexcept;
    /// Moves to the first message that is not earlier than `time`.
    void seek(robotlink::Instant time);
    /// Time of the message that next() will return; empty at the end.
    std::optional<robotlink::Instant> nextTime();
    /// Returns the next message; empty at the end. Unreadable messages are skipped and counted.
    std::optional<robotlink::StreamMessage> next();
    /// How many messages of each stream were left out since this was made.
    const std::map<std::string, std::uint64_t>& unread() const;

   private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
  };

 private:
  friend class Cursor;
  struct Implementation;
  explicit LogFile(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace logplayer
