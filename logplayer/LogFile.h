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

#include "logplayer/mcap/Reader.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

class ContainerFile;

/// A log file as streams of messages, read lazily. Types that the program does not know are built from the
/// file's own schemas; messages keep what they need alive.
///
/// Files of older formats (see LogImport.h) are converted into a temporary file first, which is removed in
/// the end, and are read-only. If a recorder was killed, what its last frames lack is not shown: a frame is
/// complete or absent.
///
/// Thread-safe; a call may wait for another one's disk access.
class LogFile {
 public:
  /// The share done in [0, 1]; false: give up.
  using Progress = std::function<bool(double)>;
  struct Options {
    std::size_t cacheBytes = 64U << 20U;
    Progress progress;
  };
  struct Stream {
    std::string path;
    std::string type;  ///< as the schema says; of the newest channel, if there are several
    std::string
        encoding;  ///< of the messages, as the file says: "protobuf", "json", "cdr"; of the newest channel
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;      ///< of its messages, uncompressed; 0 until counted
    std::uint64_t undecoded = 0;  ///< messages in an encoding that is not read; they stay bytes
    robotlink::Instant first, last;

    bool isDecoded() const { return undecoded < count; }
    /// Whether its messages are values of this type.
    bool holds(std::string_view typeName) const { return type == typeName && isDecoded(); }
  };
  static robotlink::Result<std::shared_ptr<LogFile>> open(const std::filesystem::path& file,
                                                          const Options& options);
  /// One that is open already: `reader` reads `container`.
  static std::shared_ptr<LogFile> of(const std::filesystem::path& file, ContainerFile container,
                                     std::unique_ptr<mcap::Reader> reader);
  ~LogFile();

  const std::filesystem::path& path() const;
  bool readOnly() const;
  /// Sorted by path.
  const std::vector<Stream>& streams() const;
  /// Counts Stream::bytes by reading what is needed. Empty: given up by progress.
  std::vector<Stream> countBytes(const Progress& progress);
  /// Those that the log says to be robots, not any first part of a path.
  std::vector<std::string> robots() const;
  /// The times of the first and the last message that robots published, apart from latched ones, which may be
  /// older than the recording; equal if there is none.
  robotlink::Instant begin() const;
  robotlink::Instant end() const;
  bool complete() const;
  std::vector<mcap::Damage> damage() const;
  /// "12 messages could not be read ..."; empty if nothing is wrong.
  std::string damageText() const;

  /// The newest message of a stream not later than `time`; nothing if there is none. Damaged ones are skipped
  /// and counted in damage().
  std::optional<robotlink::StreamMessage> latest(const std::string& stream, robotlink::Instant time);
  /// The first message of a stream later than `time`, or the last before it.
  std::optional<robotlink::Instant> timeAfter(const std::string& stream, robotlink::Instant time);
  std::optional<robotlink::Instant> timeBefore(const std::string& stream, robotlink::Instant time);
  /// The times of all its messages, sorted.
  std::vector<robotlink::Instant> times(const std::string& stream);

  /// Goes over the messages of some streams (empty: all) in order of time; equal times in the order of the
  /// file.
  class Cursor {
   public:
    Cursor(std::shared_ptr<LogFile> file, const std::vector<std::string>& streams);
    ~Cursor();
    Cursor(Cursor&&) noexcept;
    Cursor& operator=(Cursor&&) noexcept;
    /// Before the first message that is not earlier than `time`.
    void seek(robotlink::Instant time);
    /// The time of the message that next() yields; nothing at the end.
    std::optional<robotlink::Instant> nextTime();
    /// Nothing at the end. Messages that cannot be read are left out and counted.
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
