// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "logplayer/mcap/Reader.h"
#include "logplayer/mcap/Writer.h"

namespace logplayer::mcap::test {

/// A message with its data, to be compared.
struct Told {
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  std::int64_t time = 0;  ///< ns; its publish time is one later
  std::string data;
  bool operator==(const Told&) const = default;
};
void PrintTo(const Told& told, std::ostream* out);

/// A folder for log files that is gone with this.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

std::string readBytes(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

inline Instant at(std::int64_t nanoseconds) {
  return Instant(robotlink::Duration(nanoseconds));
}

/// Adds schema "s" and channels "c1".."cN", whose ids are 1..N.
void addChannels(Writer& writer, int channels);
void write(Writer& writer, const Told& told);
/// A new file with `channels` channels and these messages, closed; flushed before each of those whose place
/// is in `flushBefore`.
void writeLog(const std::filesystem::path& file, const std::vector<Told>& messages,
              Writer::Options options = {}, const std::vector<std::size_t>& flushBefore = {},
              int channels = 3);

std::unique_ptr<Reader> open(const std::filesystem::path& file, Reader::Options options = {});
Told toldBy(const Message& message);
/// In the order of the file.
std::vector<Told> readAll(Reader& reader);
/// By next(), from before the first; messages that cannot be read are left out.
std::vector<Told> readForwards(Reader& reader, std::vector<std::uint16_t> channels = {1, 2, 3});
/// By a MessageCursor; messages that cannot be read are left out.
std::vector<Told> readByCursor(Reader& reader, const std::vector<std::uint16_t>& channels = {1, 2, 3});
/// By previous(), from behind the last.
std::vector<Told> readBackwards(Reader& reader, std::vector<std::uint16_t> channels = {1, 2, 3});

/// `count` messages 10 ns apart on channels 1..3 in turn, with data of about `bytes` that compresses by half.
std::vector<Told> someMessages(int count, std::size_t bytes = 40);

}  // namespace logplayer::mcap::test
