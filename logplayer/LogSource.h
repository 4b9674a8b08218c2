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

#include "logplayer/Bookmarks.h"
#include "logplayer/ContainerFile.h"
#include "logplayer/LogFile.h"
#include "logplayer/StreamChoice.h"
#include "logplayer/mcap/MessageCursor.h"
#include "logplayer/mcap/Reader.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// What of a log belongs together and is copied together: a frame, or a message that belongs to none.
struct LogUnit {
  robotlink::Instant time;  ///< of the frame's FrameInfo
  bool frame = false;       ///< of a program's process, not a step of the platform
  std::vector<mcap::Reader::MessageData> messages;
};

/// A log that is read to be copied, unit by unit in order of time, the messages as the bytes that they are.
/// A log of an older format is converted, and the copy is removed in the end. Memory is bounded by the
/// reader's cache and the largest frames. One thread.
class LogSource {
 public:
  /// Fails if nothing can be read, or is given up by `progress`.
  static robotlink::Result<LogSource> open(const std::filesystem::path& file,
                                           const LogFile::Progress& progress, std::size_t cacheBytes);
  ~LogSource();
  LogSource(LogSource&&) noexcept;

  /// What lies in [from, to] of the streams chosen. A FrameInfo is chosen with whatever is chosen of its
  /// process, unless it is excluded.
  void choose(std::optional<robotlink::Instant> from, std::optional<robotlink::Instant> to,
              const StreamChoice& streams);
  /// What holds until it is told anew, as of just before `from`; by stream.
  std::vector<mcap::Reader::MessageData> held();
  /// Nothing at the end.
  std::optional<LogUnit> next();
  /// The time up to which it has read.
  robotlink::Instant position() const { return position_; }

  mcap::Reader& reader() { return *reader_; }
  const std::filesystem::path& file() const { return file_; }
  const std::vector<Bookmark>& bookmarks() const { return bookmarks_; }
  /// First parts of the paths that have several.
  const std::set<std::string>& robots() const { return robots_; }
  /// What is good to know, a sentence each.
  const std::vector<std::string>& notes() const { return notes_; }
  /// What was not read so far, a sentence each.
  std::vector<std::string> losses() const;

 private:
  struct Process {
    std::string frames;  ///< the path of its FrameInfos
    bool ends = false;   ///< whether these are copied
    std::map<std::uint32_t, std::vector<mcap::Reader::MessageData>>
        open;                           ///< frames whose FrameInfo has not come yet
    std::optional<std::uint32_t> done;  ///< the last frame of which it has come...
    bool doneKept = false;              ///< ...and that was kept
  };

  LogSource() = default;
  void noteConversion(const ImportReport& report);
  void listProcesses();
  void place(mcap::Reader::MessageData data);
  void endFrame(Process& process, mcap::Reader::MessageData frameInfo);
  void forgetOpenFrames(Process& process, std::size_t maxOpen);
  bool inRange(robotlink::Instant time) const;

  std::filesystem::path file_;
  std::optional<ContainerFile> container_;  // outlives the reader
  std::unique_ptr<mcap::Reader> reader_;
  std::vector<Bookmark> bookmarks_;
  std::set<std::string> robots_;
  std::vector<std::string> notes_, otherLosses_;

  std::optional<robotlink::Instant> from_, to_;
  std::vector<Process> processes_;
  std::map<std::uint16_t, Process*> processOf_;  // by channel; those whose messages belong to no frame lack
  std::vector<std::uint16_t> channels_;          // that are read
  std::deque<LogUnit> ready_;
  std::optional<mcap::MessageCursor> cursor_;  // over them
  robotlink::Instant position_;
  bool atEnd_ = false;
  std::uint64_t incompleteFrames_ = 0;
  std::uint64_t unread_ = 0;
};

}  // namespace logplayer
