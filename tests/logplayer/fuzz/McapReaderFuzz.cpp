// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>

#include "logplayer/mcap/read/MessageCursor.h"
#include "logplayer/mcap/read/Reader.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/logplayer/fuzz/McapSeeds.h"

namespace mcap_reader_fuzz {

using namespace logplayer::mcap;

namespace {

/// The input as a file in memory.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    require(descriptor_ >= 0 && ::write(descriptor_, data, size) == static_cast<ssize_t>(size),
            "the input can be put into memory");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }
  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

/// The sum of all bytes, so that all of them are looked at.
unsigned touch(Bytes bytes) {
  unsigned sum = 0;
  for (const std::uint8_t byte : bytes) sum += byte;
  return sum;
}

std::size_t goOver(Reader& reader, const std::vector<std::uint16_t>& channels, bool forwards) {
  std::size_t count = 0;
  MessagePosition position{forwards ? Instant::min() : Instant::max(), forwards ? 0 : UINT64_MAX,
                           forwards ? 0 : UINT64_MAX, static_cast<std::uint16_t>(forwards ? 0 : UINT16_MAX)};
  while (const auto found =
             forwards ? reader.next(position, channels) : reader.previous(position, channels)) {
    require(forwards ? position < *found : *found < position, "positions are in order");
    position = *found;
    ++count;
  }
  return count;
}

void readMessages(Reader& reader, const std::vector<std::uint16_t>& channels) {
  MessagePosition position{Instant::min(), 0, 0, 0};
  while (const auto next = reader.next(position, channels)) {
    if (const auto message = reader.read(*next)) touch(message->message.data);
    position = *next;
  }
}

/// As readMessages(), in one go. Returns how many could be read.
std::size_t readByCursor(Reader& reader, const std::vector<std::uint16_t>& channels) {
  std::size_t count = 0;
  MessagePosition position{Instant::min(), 0, 0, 0};
  for (MessageCursor cursor(reader, channels); cursor.next();) {
    require(position < cursor.position(), "the cursor goes in order");
    position = cursor.position();
    if (!cursor.readable()) continue;
    touch(cursor.data().message.data);
    ++count;
  }
  return count;
}

void lookAtEverything(Reader& reader) {
  std::vector<std::uint16_t> channels;
  for (const auto& [id, channel] : reader.channels()) channels.push_back(id);
  for (const std::uint16_t channel : channels) {
    const std::vector<Instant> times = reader.times(channel);
    if (times.empty()) continue;
    require(reader.latest(channel, times.back()).has_value(), "the newest message is found");
    require(
        !reader.latest(channel, times.front() - robotlink::Duration(1)) || times.front() == Instant::min(),
        "there is none before the first");
  }
  require(goOver(reader, channels, true) == goOver(reader, channels, false), "as many forwards as backwards");
  readMessages(reader, channels);
  const std::size_t messages = readByCursor(reader, channels);
  if (reader.damage().empty())
    require(messages == goOver(reader, channels, true), "the cursor finds what steps find");
  reader.readAll([](const Message& message) {
    touch(message.data);
    return true;
  });
  for (const std::string& name : reader.attachmentNames()) static_cast<void>(reader.attachment(name));
  static_cast<void>(reader.metadata());
  require(reader.verify().has_value(), "it is not given up");
}

/// With a reader that knows nothing of the file's lies yet.
void lookFirstByCursor(const std::filesystem::path& file, const Reader::Options& options) {
  const auto reader = Reader::open(file, options);
  if (!reader) return;
  std::vector<std::uint16_t> channels;
  for (const auto& [id, channel] : (*reader)->channels()) channels.push_back(id);
  readByCursor(**reader, channels);
}

void repairIt(const std::filesystem::path& from) {
  const std::filesystem::path to = "/dev/shm/mcap-fuzz-" + std::to_string(::getpid());
  const auto report = repair(from, to);
  if (report) {
    std::filesystem::remove(to);
  } else {
    require(report.error().id != "mcap.repair", "what was repaired is read as it was written");
    require(!std::filesystem::exists(to), "nothing is left of a repair that failed");
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  Reader::Options options;
  options.cacheBytes = 256U << 10U;
  options.maxRecordBytes = 1U << 20U;
  auto reader = Reader::open(file.path(), options);
  if (!reader) return 0;
  lookAtEverything(**reader);
  if (size % 3 == 0) lookFirstByCursor(file.path(), options);
  if (size % 4 == 0) repairIt(file.path());
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return mcapSeeds();
}

const FuzzRegistration kTarget({"mcap_reader", &fuzzSeeds, &runInput});

}  // namespace mcap_reader_fuzz
