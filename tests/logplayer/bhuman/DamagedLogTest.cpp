// SPDX-License-Identifier: GPL-3.0-or-later
// Whole logs, damaged in ten thousand places.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>

#include "logplayer/bhuman/QueueImport.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Random.h"
#include "tests/game/Data.h"
#include "tests/logplayer/bhuman/MemoryBytes.h"

using namespace logplayer;
using namespace logplayer::bhuman;

namespace {

std::size_t peakMemory() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Reads all messages, and makes frames of those around a place. How many messages there were.
std::uint64_t readAround(std::span<const std::uint8_t> log, std::size_t place) {
  constexpr std::uint64_t kAround = 30000;
  const auto source = bytesInMemory(log);
  MessageQueueReader reader(*source);
  FrameConverter converter(
      "nao", [](const FrameConverter::Frame&) { return robotlink::Result<void>(); },
      [](std::uint64_t, const std::string&) {});
  std::uint64_t messages = 0;
  while (const auto message = reader.next()) {
    ++messages;
    const bool near = reader.position() + kAround > place && message->offset < place + kAround;
    if (near && !converter.add(*message)) return 0;
  }
  return converter.finish() ? messages : 0;
}

/// The parameter is the source of the log.
class DamagedLog : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto file = game::dataOf(GetParam()) / "logs/bhuman2009.log";
    const auto text = robotlink::readFile(file);
    if (!text) GTEST_SKIP() << "the real log is not at " << file;
    log.assign(text->begin(), text->end());
  }
  std::vector<std::uint8_t> log;
};

}  // namespace

TEST_P(DamagedLog, aFlippedBitCostsFewMessagesAndDoesNoHarm) {
  const std::uint64_t all = readAround(log, 0);
  const std::size_t before = peakMemory();
  robotlink::Random random(2009);
  for (int i = 0; i < 10000; ++i) {
    const std::size_t at = random.bits() % log.size();
    const auto flip = static_cast<std::uint8_t>(1U << (random.bits() % 8));
    log[at] = static_cast<std::uint8_t>(log[at] ^ flip);
    EXPECT_GE(readAround(log, at) + 3, all) << "byte " << at << " flipped by " << int{flip};
    log[at] = static_cast<std::uint8_t>(log[at] ^ flip);
  }
  EXPECT_LT(peakMemory() - before, std::size_t{100} << 20U);
}

TEST_P(DamagedLog, headersOfMessagesCostFewMessages) {
  const std::uint64_t all = readAround(log, 0);
  std::vector<std::uint64_t> offsets;
  {
    const auto source = bytesInMemory(log);
    MessageQueueReader reader(*source);
    while (const auto message = reader.next()) offsets.push_back(message->offset);
  }
  robotlink::Random random(7);
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const std::size_t at = static_cast<std::size_t>(offsets[random.bits() % offsets.size()] + i % 4);
    const std::uint8_t was = log[at];
    log[at] = static_cast<std::uint8_t>(random.bits());
    EXPECT_GE(readAround(log, at) + 3, all)
        << "byte " << at << " from " << int{was} << " to " << int{log[at]};
    log[at] = was;
  }
}

TEST_P(DamagedLog, aCutLogYieldsWhatIsBeforeTheCut) {
  robotlink::Random random(1);
  for (int i = 0; i < 300; ++i) {
    const std::size_t size = random.bits() % log.size();
    std::uint64_t whole = 0;
    {
      const auto source = bytesInMemory(log);
      MessageQueueReader reader(*source);
      while (reader.next() && reader.position() <= size) ++whole;
    }
    EXPECT_EQ(readAround(std::span(log).first(size), size), whole) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Logs, DamagedLog, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });
