// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/LogFile.h"
#include "logplayer/StreamChoice.h"
#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// One of the logs that are written into a new one. Older formats are converted on the way.
struct RewriteInput {
  std::filesystem::path file;
  robotlink::Duration offset{0};  ///< added to all its times, also to those in its messages
};

/// How several logs are put together.
enum class Joining : std::uint8_t {
  kAutomatic,    ///< behind each other where they are parts of one log, else beside each other
  kConcatenate,  ///< behind each other: robots keep their names; fails where that makes no sense
  kSeparate,     ///< beside each other: robots of equal names get other ones
};

struct RewriteOptions {
  std::vector<RewriteInput> inputs = {};
  /// What lies in [from, to] is kept, in times of the new log; unset: from the start, to the end.
  std::optional<robotlink::Instant> from = {}, to = {};
  StreamChoice streams = {};
  Joining joining = Joining::kAutomatic;
  mcap::Compression compression = mcap::Compression::kZstd;
  std::size_t chunkBytes = 1U << 20U;  ///< when a chunk is complete; frames stay whole
  bool overwrite = false;              ///< a file of the new one's name; else it must not exist
  LogFile::Progress progress = {};
};

/// What a new log was made of.
struct RewriteReport {
  std::uint64_t messages = 0;  ///< in the new file
  std::uint64_t frames = 0;    ///< of the robots' processes, the platform's steps apart
  std::uint64_t bookmarks = 0;
  std::uint64_t bytes = 0;  ///< of the file
  robotlink::Instant begin, end;
  bool concatenated = false;                   ///< the logs were put behind each other
  std::map<std::string, std::string> renamed;  ///< "b.mcap: red1" -> "red1-2"
  std::vector<std::string> notes;              ///< what is good to know, a sentence each
  std::vector<std::string> losses;             ///< what of the inputs could not be read; empty if all was
};

/// Writes a part of one or several logs into a new one: cuts by time, filters by streams, merges, and all of
/// that at once. Messages are copied as they are, of unknown types, too. The new log begins with what holds
/// until it is told anew; frames are in it as a whole or not at all (a frame belongs where its FrameInfo is);
/// FrameInfos stay with whatever is kept of their process, unless they are excluded. Bookmarks in the range
/// are in it, also those from beside the logs. Fails if nothing would be left.
///
/// Logs whose times do not overlap, and in which robots of equal names run the same program, are parts of
/// one: they are put behind each other, and what two of them repeat where they meet is written once.
/// Otherwise, if several logs have a robot of the same name, the later ones get "-2", "-3" behind it, and of
/// streams that belong to no robot (the scene) those of the first log that has them are taken. Memory is
/// bounded by the readers' caches and the largest frames.
///
/// The new file gets its name when it is complete; if anything fails, or is given up by progress, nothing is
/// left.
robotlink::Result<RewriteReport> rewriteLogs(const RewriteOptions& options, const std::filesystem::path& to);

}  // namespace logplayer
