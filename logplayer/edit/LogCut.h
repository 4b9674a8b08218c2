// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/base/StreamFilter.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/mcap/Records.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A log that is merged with others into a new one. Older formats are converted on the fly.
struct RewriteInput {
  std::filesystem::path file;
  /// Added to all times, including timestamps inside messages.
  robotlink::Duration offset{0};
};

/// How several logs are combined.
enum class Joining : std::uint8_t {
  /// kConcatenate if they are parts of one log, else kSeparate.
  kAutomatic,
  /// The logs follow one another; robots keep their names. Fails if the logs do not continue each other.
  kConcatenate,
  /// In parallel; robots of equal names are renamed.
  kSeparate,
};

/// Inputs, selection and format of a new log.
struct RewriteOptions {
  std::vector<RewriteInput> inputs = {};
  /// The range [from, to] to keep, in times of the new log; unset: from the start, to the end.
  std::optional<robotlink::Instant> from = {}, to = {};
  StreamFilter streams = {};
  Joining joining = Joining::kAutomatic;
  mcap::Compression compression = mcap::Compression::kZstd;
  /// Chunks are closed at this size; frames stay whole.
  std::size_t chunkBytes = 1U << 20U;
  /// Whether an existing file is replaced; otherwise the file must not exist.
  bool overwrite = false;
  LogFile::Progress progress = {};
};

/// The contents of a new log.
struct RewriteReport {
  /// Number of messages in the new file.
  std::uint64_t messages = 0;
  /// Number of frames of the robots' processes, without the steps of the platform.
  std::uint64_t frames = 0;
  std::uint64_t bookmarks = 0;
  /// Size of the new file.
  std::uint64_t bytes = 0;
  /// Times of the first and the last message.
  robotlink::Instant begin, end;
  /// Whether the logs were concatenated.
  bool concatenated = false;
  /// Robots that got a new name: "b.mcap: red1" -> "red1-2".
  std::map<std::string, std::string> renamed;
  /// Information for the user, one sentence each.
  std::vector<std::string> notes;
  /// The data that could not be read from the inputs, one sentence each; empty if all data was read.
  std::vector<std::string> losses;
};

/// Writes a part of one or several logs into a new one: cuts by time, filters by stream, merges, or any
/// combination. Messages are copied unchanged, even those of unknown types. The new log begins with the
/// latched messages at its start. Frames are copied as a whole or not at all (a frame lies where its
/// FrameInfo is); the FrameInfos of a process are copied with any of its streams, unless they are excluded.
/// Bookmarks in the range are copied, also those from files beside the logs. Fails if nothing would be left.
///
/// Logs whose times do not overlap, and in which robots of equal names run the same program, are considered
/// parts of one log: they are concatenated, and messages that two of them repeat at the seam are written
/// once. Otherwise, if several logs have a robot of the same name, the later ones get the suffix "-2", "-3";
/// streams that belong to no robot (the scene) are copied from the first log that has them. Memory is bounded
/// by the readers' caches and the largest frames.
///
/// The new file gets its name when it is complete; if anything fails, or the progress callback cancels,
/// nothing is left.
robotlink::Result<RewriteReport> rewriteLogs(const RewriteOptions& options, const std::filesystem::path& to);

}  // namespace logplayer
