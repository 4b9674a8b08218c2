// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/write/Writer.h"
#include "tests/TestFolder.h"

namespace logplayer::mcap::test {

/// A message with its data, for comparison.
struct Expected {
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  /// Log time in ns; the publish time is 1 ns later.
  std::int64_t time = 0;
  std::string data;
  bool operator==(const Expected&) const = default;
};
void PrintTo(const Expected& expected, std::ostream* out);

/// A folder for log files, in memory.
struct TemporaryFolder : TestFolder {
  TemporaryFolder() : TestFolder(Where::kMemory) {}
};

std::string readBytes(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

inline Instant at(std::int64_t nanoseconds) {
  return Instant(robotlink::Duration(nanoseconds));
}

/// Adds the schema "s" and the channels "c1".."cN" with the ids 1..N.
void addChannels(Writer& writer, int channels);
void write(Writer& writer, const Expected& expected);
/// Writes a new file with `channels` channels and these messages, and closes it. `flushBefore`: indices of
/// messages before which the open chunk is written.
void writeLog(const std::filesystem::path& file, const std::vector<Expected>& messages,
              Writer::Options options = {}, const std::vector<std::size_t>& flushBefore = {},
              int channels = 3);

std::unique_ptr<Reader> open(const std::filesystem::path& file, Reader::Options options = {});
Expected readFrom(const Message& message);
/// In the order of the file.
std::vector<Expected> readAll(Reader& reader);
/// Read by next() from the start; messages that cannot be read are skipped.
std::vector<Expected> readForwards(Reader& reader, std::vector<std::uint16_t> channels = {1, 2, 3});
/// Read by a MessageCursor; messages that cannot be read are left out.
std::vector<Expected> readByCursor(Reader& reader, const std::vector<std::uint16_t>& channels = {1, 2, 3});
/// Read by previous(), from behind the last.
std::vector<Expected> readBackwards(Reader& reader, std::vector<std::uint16_t> channels = {1, 2, 3});

/// `count` messages 10 ns apart on channels 1..3 in turn, with about `bytes` bytes of data that compress by
/// half.
std::vector<Expected> someMessages(int count, std::size_t bytes = 40);

}  // namespace logplayer::mcap::test
