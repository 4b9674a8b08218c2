// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "logplayer/Bookmarks.h"
#include "logplayer/LogFile.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// What a log file holds, counted.
struct LogInfo {
  struct Stream {
    std::string path;
    std::string type;
    std::string encoding;         ///< of the messages: "protobuf", "json", "cdr"
    std::uint64_t undecoded = 0;  ///< messages in an encoding that is not read
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  ///< of its messages, uncompressed
    double rate = 0;          ///< Hz between the first and the last; 0 with fewer than two
    robotlink::Instant first, last;
  };
  std::filesystem::path file;
  std::string format;  ///< "MCAP", or the older format that was converted: "B-Human message queue"
  std::uint64_t fileBytes = 0;
  robotlink::Instant begin, end;  ///< of what robots told; equal if there is nothing
  std::vector<std::string> robots;
  std::uint64_t messages = 0;
  std::uint64_t frames = 0;                       ///< of the robots' processes, the platform's steps apart
  std::map<std::string, std::uint64_t> framesOf;  ///< "<robot>/<process>", the platforms', too
  std::uint64_t images = 0;
  std::vector<Bookmark> bookmarks;
  std::vector<Stream> streams;  ///< by path

  // What the container holds; nothing for older formats.
  std::uint64_t chunks = 0;
  std::uint64_t compressedBytes = 0, uncompressedBytes = 0;  ///< of all chunks
  std::map<std::string, std::uint64_t> compressions;         ///< chunks by "none", "lz4", "zstd"
  std::string library;                                       ///< that wrote it
  std::vector<std::string> attachments;
  std::vector<mcap::Metadata> metadata;

  bool complete = true;  ///< ends as it should
  std::vector<mcap::Damage> damage;
  std::vector<std::string> losses;                     ///< all that is wrong, a sentence each
  std::map<std::string, std::uint64_t> notUnderstood;  ///< messages of an older format, by kind
};

/// Reads what it needs to count; given up by progress it fails with "log.given-up".
robotlink::Result<LogInfo> readLogInfo(const std::filesystem::path& file,
                                       const LogFile::Progress& progress = {});

/// As `robotctl log info --json` prints it: snake_case, SI units.
nlohmann::json toJson(const LogInfo& info);
/// For people: aligned columns with units, lines ended.
std::string toText(const LogInfo& info);

}  // namespace logplayer
