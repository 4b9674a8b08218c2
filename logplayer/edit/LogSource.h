// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/base/StreamFilter.h"
#include "logplayer/bookmarks/Bookmarks.h"
#include "logplayer/file/ContainerFile.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/mcap/read/MessageCursor.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Messages of a log that are copied together: a frame, or a single message that belongs to no frame.
struct LogUnit {
  /// Time of the frame's FrameInfo, or of the message.
  robotlink::Instant time;
  /// Whether it is a frame of a program's process; false also for steps of the platform.
  bool frame = false;
  std::vector<mcap::Reader::MessageData> messages;
};

/// A log that is read to be copied, unit by unit in order of time, with messages as raw bytes.
/// A log of an older format is converted, and the copy is removed in the end. Memory is bounded by the
/// reader's cache and the largest frames. One thread.
class LogSource {
 public:
  /// Fails if nothing can be read, or with "log.given-up" if `progress` returns false. Everything is selected
  /// at first, see choose().
  static robotlink::Result<LogSource> open(const std::filesystem::path& file,
                                           const LogFile::Progress& progress, std::size_t cacheBytes);
  ~LogSource();
  LogSource(LogSource&&) noexcept;

  /// Selects the range [from, to] of some streams and starts from the beginning. The FrameInfos of a process
  /// are selected together with any of its streams, unless they are excluded.
  void choose(std::optional<robotlink::Instant> from, std::optional<robotlink::Instant> to,
              const StreamFilter& streams);
  /// The latched messages just before `from`, one per channel.
  std::vector<mcap::Reader::MessageData> held();
  /// Returns the next unit; empty at the end.
  std::optional<LogUnit> next();
  /// The time up to which the log has been read.
  robotlink::Instant position() const { return position_; }

  /// The reader of the log, or of its converted copy.
  mcap::Reader& reader() { return *reader_; }
  const std::filesystem::path& file() const { return file_; }
  /// All bookmarks, also those from the file beside the log.
  const std::vector<Bookmark>& bookmarks() const { return bookmarks_; }
  /// The robots of the log, see LogChannels::robots().
  const std::set<std::string>& robots() const { return robots_; }
  /// Information for the user, one sentence each.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Returns the data that could not be read so far, one sentence each.
  std::vector<std::string> losses() const;

 private:
  /// The frames of one process that are being collected.
  struct Process {
    /// Path of its FrameInfos.
    std::string frames;
    /// Whether its FrameInfos are copied.
    bool ends = false;
    /// Frames whose FrameInfo has not been read yet, by number.
    std::map<std::uint32_t, std::vector<mcap::Reader::MessageData>> open;
    /// The last frame whose FrameInfo was read, for messages that follow it.
    std::optional<std::uint32_t> done;
    /// Whether that frame was in the range.
    bool doneKept = false;
  };

  LogSource() = default;
  /// Adds what the conversion left out to notes and losses.
  void noteConversion(const ImportReport& report);
  /// Finds the processes by the channels of their FrameInfos.
  void listProcesses();
  /// Adds a message to its frame, or makes it a unit of its own.
  void place(mcap::Reader::MessageData data);
  /// Completes a frame.
  void endFrame(Process& process, mcap::Reader::MessageData frameInfo);
  void forgetOpenFrames(Process& process, std::size_t maxOpen);
  bool inRange(robotlink::Instant time) const;

  std::filesystem::path file_;
  /// Declared before the reader, which it must outlive.
  std::optional<ContainerFile> container_;
  std::unique_ptr<mcap::Reader> reader_;
  std::vector<Bookmark> bookmarks_;
  std::set<std::string> robots_;
  std::vector<std::string> notes_, otherLosses_;

  std::optional<robotlink::Instant> from_, to_;
  std::vector<Process> processes_;
  /// Keyed by channel; without channels whose messages belong to no frame.
  std::map<std::uint16_t, Process*> processOf_;
  /// The channels to read.
  std::vector<std::uint16_t> channels_;
  /// Complete units that next() has not returned yet.
  std::deque<LogUnit> ready_;
  std::optional<mcap::MessageCursor> cursor_;  // over them
  robotlink::Instant position_;
  bool atEnd_ = false;
  std::uint64_t incompleteFrames_ = 0;
  std::uint64_t unread_ = 0;
};

}  // namespace logplayer
