// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "logplayer/bookmarks/Bookmarks.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A summary of the contents of a log file, for `robotctl log info` and views.
struct LogInfo {
  /// A summary of one stream.
  struct Stream {
    std::string path;
    std::string type;
    /// Encoding of the messages: "protobuf", "json", "cdr".
    std::string encoding;
    /// Number of messages in encodings that are not supported.
    std::uint64_t undecoded = 0;
    std::uint64_t count = 0;
    /// Uncompressed size of the messages.
    std::uint64_t bytes = 0;
    /// Mean rate between the first and the last message, Hz; 0 if there are fewer than two.
    double rate = 0;
    robotlink::Instant first, last;
  };
  std::filesystem::path file;
  /// "MCAP", or the older format that was converted: "B-Human message queue".
  std::string format;
  std::uint64_t fileBytes = 0;
  /// The range of the log's time, see LogFile::begin() and LogFile::end().
  robotlink::Instant begin, end;
  std::vector<std::string> robots;
  std::uint64_t messages = 0;
  /// Number of frames of the robots' processes, without the steps of the platform.
  std::uint64_t frames = 0;
  /// Frames by "<robot>/<process>", including those of the platforms.
  std::map<std::string, std::uint64_t> framesOf;
  /// Number of messages with images.
  std::uint64_t images = 0;
  std::vector<Bookmark> bookmarks;
  /// Sorted by path.
  std::vector<Stream> streams;

  // The contents of the container; 0 for older formats.
  std::uint64_t chunks = 0;
  /// Sums over all chunks.
  std::uint64_t compressedBytes = 0, uncompressedBytes = 0;
  /// Number of chunks by compression: "none", "lz4", "zstd".
  std::map<std::string, std::uint64_t> compressions;
  /// The software that wrote the file.
  std::string library;
  /// Names of the attached files.
  std::vector<std::string> attachments;
  std::vector<mcap::Metadata> metadata;

  /// Whether the file was closed properly.
  bool complete = true;
  std::vector<mcap::Damage> damage;
  /// Everything that is wrong, one sentence each.
  std::vector<std::string> losses;
  /// Messages of an older format that were left out, by kind.
  std::map<std::string, std::uint64_t> notUnderstood;
};

/// Reads the whole file in order to count. Fails with "log.given-up" if canceled by the progress callback.
robotlink::Result<LogInfo> readLogInfo(const std::filesystem::path& file,
                                       const LogFile::Progress& progress = {});

/// The output of `robotctl log info --json`: names in snake_case, SI units.
nlohmann::json toJson(const LogInfo& info);
/// For the user: aligned columns with units; every line ends with a newline.
std::string toText(const LogInfo& info);

}  // namespace logplayer
