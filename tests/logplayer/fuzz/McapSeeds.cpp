// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/fuzz/McapSeeds.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/write/Writer.h"

using namespace logplayer::mcap;

namespace {

std::string bytesOfFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Instant at(std::int64_t nanoseconds) {
  return Instant(robotlink::Duration(nanoseconds));
}

std::string written(const std::filesystem::path& folder, Compression compression, bool crc, int messages) {
  const auto file = folder / "seed.mcap";
  std::filesystem::remove(file);
  Writer::Options options;
  options.compression = compression;
  options.crc = crc;
  options.chunkBytes = 400;
  auto writer = Writer::create(file, options);
  if (!writer) return {};
  const auto schema = (*writer)->addSchema("s", "protobuf", "description");
  for (int i = 0; i < 3; ++i) {
    static_cast<void>(
        (*writer)->addChannel("c" + std::to_string(i), *schema, "protobuf", {{"process", "p"}}));
  }
  for (int i = 0; i < messages; ++i) {
    const std::string data(static_cast<std::size_t>(i % 50), static_cast<char>('a' + i % 20));
    const std::int64_t time = i % 5 == 4 ? 10 * i - 100 : 10 * i;  // some out of order
    static_cast<void>((*writer)->write({static_cast<std::uint16_t>(1 + i % 3), static_cast<std::uint32_t>(i),
                                        at(std::max<std::int64_t>(0, time)), at(time + 1), bytesOf(data)}));
  }
  static_cast<void>((*writer)->attach({at(1), at(2), "notes", "text/plain", "some text"}));
  static_cast<void>((*writer)->addMetadata({"m", {{"key", "value"}}}));
  static_cast<void>((*writer)->close());
  writer->reset();
  return bytesOfFile(file);
}

/// Messages outside of chunks, private records, and no summary.
std::string unchunked() {
  Buffer out(std::begin(kMagic), std::end(kMagic));
  encode(out, Header{"", ""});
  encode(out, Schema{1, "s", "protobuf", "description"});
  encode(out, Channel{1, 1, "c1", "protobuf", {}});
  const std::uint8_t data[] = {1, 2, 3, 4, 5};
  for (int i = 0; i < 10; ++i) encode(out, Message{1, 0, at(i), at(i), data});
  const std::uint8_t privateRecord[] = {0x80, 2, 0, 0, 0, 0, 0, 0, 0, 7, 7};
  out.insert(out.end(), std::begin(privateRecord), std::end(privateRecord));
  encode(out, DataEnd{});
  encode(out, Footer{});
  out.insert(out.end(), std::begin(kMagic), std::end(kMagic));
  return std::string(textOf(out));
}

void addConformanceFiles(const std::filesystem::path& folder, std::vector<std::string>& seeds) {
  const std::filesystem::path archive =
      ROBOTCONTROL_SOURCE_DIR "/../shared/data/mcap-conformance/files.tar.xz";
  if (!std::filesystem::exists(archive)) return;
  const std::string command = "tar -xf '" + archive.string() + "' -C '" + folder.string() + "' 2>/dev/null";
  if (std::system(command.c_str()) != 0) return;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".mcap" && entry.path().filename() != "seed.mcap")
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (std::size_t i = 0; i < files.size(); i += 8) seeds.push_back(bytesOfFile(files[i]));
}

}  // namespace

std::vector<std::string> mcapSeeds() {
  std::string name = (std::filesystem::temp_directory_path() / "mcap-seeds-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) return {};
  const std::filesystem::path folder = name;
  std::vector<std::string> seeds{unchunked()};
  for (const Compression compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    for (const bool crc : {true, false}) {
      seeds.push_back(written(folder, compression, crc, 60));
      const std::string& whole = seeds.back();
      seeds.push_back(whole.substr(0, whole.size() * 2 / 3));
      seeds.push_back(written(folder, compression, crc, 3));
    }
  }
  addConformanceFiles(folder, seeds);
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return seeds;
}
