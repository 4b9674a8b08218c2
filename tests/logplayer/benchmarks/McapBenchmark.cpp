// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>

#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/Source.h"
#include "logplayer/mcap/read/MessageCursor.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/write/Writer.h"

// Writes and reads 400 MB of messages on 20 channels in memory, for three sizes of messages, three ways to
// write them, and two kinds of data: hardly compressible (A), and like a robot's sensor readings (B). What
// counts for writing, opening and seeking is the processor time of the thread, the system's part included, so
// others on the machine count little. Each row's reference is the bare write() of as many bytes, measured in
// the same row: uncompressed messages of 10 kB, with CRC, are to be written at no less than 0.6 of its speed.
// Columns: MB/s of messages' data written, read in the order of the file, and in the order of time by a
// MessageCursor, and verified; ms to open; us to find and read the newest message of a channel at a random
// time, and that of all channels.
//
// Reading uses two threads that read ahead, so that it is measured by wall clock: use a machine with two
// idle cores. It has references of its own: file_of_bare is the speed in the order of the file as a share of
// reading and decompressing the same chunks and copying them once, by one thread; time_of_file is that in the
// order of time as a share of that in the order of the file, time_3MiB the same where both have a cache of
// 3 MiB, steps_of_file that of single steps with next() and read(), for comparison. The first three are to be
// at least 0.9, 0.95 and 0.95. file_cpu is the processor time of all threads for reading in the order of the
// file, as a multiple of that of the reference, time_cpu that in the order of time as a multiple of that in
// the order of the file. What is compared is measured in turns, and the best of fifteen counts.
namespace {

using namespace logplayer::mcap;

constexpr std::size_t kBytes = 400'000'000;
constexpr std::size_t kPoolBytes = 16U << 20U;
constexpr int kChannels = 20;
const std::filesystem::path kFile = "/dev/shm/mcap-benchmark.mcap";

double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double processSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double secondsFor(const std::function<void()>& work) {
  const double start = threadSeconds();
  work();
  return threadSeconds() - start;
}

double quantile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + place);
  return values[static_cast<std::size_t>(place)];
}

std::vector<std::uint8_t> hardlyCompressible() {
  std::mt19937_64 random(1);
  std::vector<std::uint8_t> pool(kPoolBytes);
  for (std::size_t i = 0; i + 8 <= pool.size(); i += 8) storeNumber(pool.data() + i, random());
  return pool;
}

/// Records of 16-bit readings: slow signals with noise in their lower bits, beside counters and constants.
std::vector<std::uint8_t> robotLike() {
  std::minstd_rand random(1);
  std::vector<std::uint8_t> pool(kPoolBytes);
  for (std::size_t i = 0; i + 32 <= pool.size(); i += 32) {
    const double phase = static_cast<double>(i) * 1e-4;
    storeNumber(pool.data() + i, static_cast<std::uint32_t>(i / 32));
    for (std::size_t k = 2; k < 12; ++k) {
      const double signal =
          8000 * std::sin(phase * static_cast<double>(k)) + static_cast<double>(random() & 0x0F);
      storeNumber(pool.data() + i + 2 * k, static_cast<std::uint16_t>(static_cast<int>(signal)));
    }
    storeNumber(pool.data() + i + 24, std::uint64_t{0x0001000200030004});
  }
  return pool;
}

struct Cell {
  std::size_t messageBytes;
  Writer::Options options;
  const std::vector<std::uint8_t>* pool;
};

/// Views of the pool, one behind the other, around and around.
class Slices {
 public:
  Slices(const std::vector<std::uint8_t>& pool, std::size_t bytes) : pool_(pool), bytes_(bytes) {}
  Bytes next() {
    if (at_ + bytes_ > pool_.size()) at_ = 0;
    at_ += bytes_;
    return Bytes(pool_).subspan(at_ - bytes_, bytes_);
  }

 private:
  const std::vector<std::uint8_t>& pool_;
  std::size_t bytes_;
  std::size_t at_ = 0;
};

bool writeLog(const Cell& cell) {
  auto writer = Writer::create(kFile, cell.options);
  if (!writer) return false;
  const auto schema = (*writer)->addSchema("s", "protobuf", "");
  for (int i = 0; i < kChannels; ++i) {
    static_cast<void>((*writer)->addChannel("c" + std::to_string(i), *schema, "protobuf", {}));
  }
  Slices slices(*cell.pool, cell.messageBytes);
  for (std::size_t i = 0; i < kBytes / cell.messageBytes; ++i) {
    const Instant time{std::chrono::microseconds(100 * i)};
    const auto channel = static_cast<std::uint16_t>(1 + i % kChannels);
    if (!(*writer)->write({channel, static_cast<std::uint32_t>(i), time, time, slices.next()})) return false;
  }
  return (*writer)->close().has_value();
}

/// As many bytes as the file has, in pieces as large as chunks.
bool writeBare(const Cell& cell, std::size_t fileBytes) {
  const int file = ::open(kFile.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0644);
  Slices slices(*cell.pool, 1U << 20U);
  bool good = file >= 0;
  for (std::size_t left = fileBytes; good && left > 0;) {
    const ssize_t written = ::write(file, slices.next().data(), std::min<std::size_t>(left, 1U << 20U));
    good = written > 0;
    left -= static_cast<std::size_t>(std::max<ssize_t>(0, written));
  }
  return ::close(file) == 0 && good;
}

Reader::Options withCache(std::size_t bytes) {
  Reader::Options options;
  options.cacheBytes = bytes;
  return options;
}

std::size_t readInFileOrder(std::size_t cacheBytes) {
  const auto reader = Reader::open(kFile, withCache(cacheBytes));
  std::size_t bytes = 0;
  (*reader)->readAll([&](const Message& message) {
    bytes += message.data.size();
    return true;
  });
  return bytes;
}

const std::vector<std::uint16_t>& allChannels() {
  static const std::vector<std::uint16_t> channels = [] {
    std::vector<std::uint16_t> ids;
    for (int i = 1; i <= kChannels; ++i) ids.push_back(static_cast<std::uint16_t>(i));
    return ids;
  }();
  return channels;
}

std::size_t readInOrderOfTime(std::size_t cacheBytes) {
  const auto reader = Reader::open(kFile, withCache(cacheBytes));
  std::size_t bytes = 0;
  for (MessageCursor cursor(**reader, allChannels()); cursor.next();) bytes += cursor.message().data.size();
  return bytes;
}

std::size_t readStepByStep(std::size_t cacheBytes) {
  const auto reader = Reader::open(kFile, withCache(cacheBytes));
  std::size_t bytes = 0;
  MessagePosition position{Instant::min(), 0, 0, 0};
  while (const auto next = (*reader)->next(position, allChannels())) {
    const auto message = (*reader)->read(*next);
    if (!message) return 0;
    bytes += message->message.data.size();
    position = *next;
  }
  return bytes;
}

/// All chunks, decompressed one after the other into the same memory, and copied from there. The reader is
/// only asked where they are.
std::size_t readBare() {
  const auto reader = Reader::open(kFile, {});
  const auto source = Source::open(kFile);
  Decompressor decompressor;
  Buffer compressed, records, copy;
  std::size_t bytes = 0;
  for (const Reader::ChunkInfo& chunk : (*reader)->chunks()) {
    const std::size_t head = chunk.length - chunk.compressedBytes;
    records.resize(chunk.uncompressedBytes);
    copy.resize(chunk.uncompressedBytes);
    const bool plain = chunk.compression == Compression::kNone;
    if (!plain) compressed.resize(chunk.compressedBytes);
    if (!source->read(chunk.offset + head, plain ? records : compressed)) return 0;
    if (!plain && !decompressor.decompress(chunk.compression, compressed, records)) return 0;
    std::ranges::copy(records, copy.begin());
    benchmark::DoNotOptimize(copy.data());
    bytes += copy.size();
  }
  return bytes;
}

constexpr std::size_t kUsualCache = 64U << 20U;
constexpr std::size_t kSmallCache = 3U << 20U;

std::size_t verifyAll() {
  const auto reader = Reader::open(kFile, {});
  const auto readable = (*reader)->verify();
  return readable && (*reader)->damage().empty() ? kBytes : 0;
}

/// The best of some turns, s.
struct Best {
  double wall = 1e9, processor = 1e9;
};

/// `good`: whether all was read in each turn.
struct Reading {
  Best bare, fileOrder, timeOrder, steps, smallFileOrder, smallTimeOrder, verify;
  bool good = true;
};

Reading readInTurns(std::size_t bytes) {
  Reading best;
  const auto measured = [&](Best& seconds, const std::function<std::size_t()>& read) {
    const double wall = wallSeconds(), processor = processSeconds();
    best.good = read() >= bytes && best.good;
    seconds.wall = std::min(seconds.wall, wallSeconds() - wall);
    seconds.processor = std::min(seconds.processor, processSeconds() - processor);
  };
  for (int turn = 0; turn < 15; ++turn) {
    measured(best.bare, readBare);
    measured(best.fileOrder, [] { return readInFileOrder(kUsualCache); });
    measured(best.timeOrder, [] { return readInOrderOfTime(kUsualCache); });
    if (turn < 2) measured(best.steps, [] { return readStepByStep(kUsualCache); });
    measured(best.smallFileOrder, [] { return readInFileOrder(kSmallCache); });
    measured(best.smallTimeOrder, [] { return readInOrderOfTime(kSmallCache); });
    measured(best.verify, verifyAll);
  }
  return best;
}

struct Seeks {
  std::vector<double> oneChannel, allChannels;  // s
};

/// With a small cache, so that hardly any place was there before.
Seeks seekAtRandom(std::size_t messages) {
  Reader::Options options;
  options.cacheBytes = 4U << 20U;
  const auto reader = Reader::open(kFile, options);
  std::minstd_rand random(1);
  Seeks seeks;
  const auto find = [&](std::uint16_t channel, Instant time) {
    const auto position = (*reader)->latest(channel, time);
    if (position) benchmark::DoNotOptimize((*reader)->read(*position));
  };
  const auto randomTime = [&] {
    return Instant{std::chrono::microseconds(100 * (kChannels + random() % messages))};
  };
  for (int i = 0; i < 400; ++i) {
    const auto channel = static_cast<std::uint16_t>(1 + random() % kChannels);
    const Instant time = randomTime();
    seeks.oneChannel.push_back(secondsFor([&] { find(channel, time); }));
  }
  for (int i = 0; i < 100; ++i) {
    const Instant time = randomTime();
    seeks.allChannels.push_back(secondsFor([&] {
      for (const std::uint16_t channel : allChannels()) find(channel, time);
    }));
  }
  return seeks;
}

double medianOpening() {
  std::vector<double> openings;
  for (int i = 0; i < 21; ++i) {
    openings.push_back(secondsFor([] { benchmark::DoNotOptimize(Reader::open(kFile, {})); }));
  }
  return quantile(openings, 0.5);
}

void measure(benchmark::State& state, const Cell& cell) {
  for (auto iteration : state) {
    std::filesystem::remove(kFile);
    const std::size_t messages = kBytes / cell.messageBytes;
    const double bytes = static_cast<double>(messages * cell.messageBytes);
    bool written = false;
    const double writing = secondsFor([&] { written = writeLog(cell); });
    const auto fileBytes = static_cast<std::size_t>(std::filesystem::file_size(kFile));
    const Reading reading = readInTurns(messages * cell.messageBytes);
    if (!written || !reading.good) return state.SkipWithError("not all was read back");
    const double opening = medianOpening();
    const Seeks seeks = seekAtRandom(messages);
    std::filesystem::remove(kFile);
    const double bare = secondsFor([&] { written = writeBare(cell, fileBytes); });
    if (!written) return state.SkipWithError("cannot write");

    state.counters["write"] = bytes / writing / 1e6;
    state.counters["of_bare"] = bare / writing;
    state.counters["ratio"] = bytes / static_cast<double>(fileBytes);
    state.counters["file_order"] = bytes / reading.fileOrder.wall / 1e6;
    state.counters["file_of_bare"] = reading.bare.wall / reading.fileOrder.wall;
    state.counters["file_cpu"] = reading.fileOrder.processor / reading.bare.processor;
    state.counters["time_cpu"] = reading.timeOrder.processor / reading.fileOrder.processor;
    state.counters["time_order"] = bytes / reading.timeOrder.wall / 1e6;
    state.counters["time_of_file"] = reading.fileOrder.wall / reading.timeOrder.wall;
    state.counters["steps_of_file"] = reading.fileOrder.wall / reading.steps.wall;
    state.counters["time_3MiB"] = reading.smallFileOrder.wall / reading.smallTimeOrder.wall;
    state.counters["verify"] = bytes / reading.verify.wall / 1e6;
    state.counters["open_ms"] = opening * 1e3;
    state.counters["seek_p50"] = quantile(seeks.oneChannel, 0.5) * 1e6;
    state.counters["seek_p99"] = quantile(seeks.oneChannel, 0.99) * 1e6;
    state.counters["all_us"] = quantile(seeks.allChannels, 0.5) * 1e6;
  }
  std::filesystem::remove(kFile);
}

bool registerAll() {
  static const std::vector<std::uint8_t> kPools[] = {hardlyCompressible(), robotLike()};
  const std::pair<const char*, Compression> ways[] = {
      {"none", Compression::kNone}, {"lz4", Compression::kLz4}, {"zstd1", Compression::kZstd}};
  for (const std::size_t bytes : {std::size_t{100}, std::size_t{10'000}, std::size_t{100'000}}) {
    for (const auto& [name, compression] : ways) {
      for (int kind = 0; kind < 2; ++kind) {
        Writer::Options options;
        options.compression = compression;
        const Cell cell{bytes, options, &kPools[kind]};
        const std::string label = std::to_string(bytes) + "B/" + name + "/" + (kind == 0 ? "A" : "B");
        benchmark::RegisterBenchmark(label.c_str(), [cell](benchmark::State& state) { measure(state, cell); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
      }
    }
  }
  return true;
}

const bool kRegistered = registerAll();

}  // namespace
