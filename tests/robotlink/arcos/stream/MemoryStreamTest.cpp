// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robotlink/arcos/stream/MemoryStream.h"

#include <gmock/gmock.h>

#include <array>
#include <thread>
#include <vector>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

struct MemoryStreamTest : testing::Test {
  std::vector<std::uint8_t> read(ByteStream& stream, std::size_t count, Duration timeout = 0ms) const {
    std::vector<std::uint8_t> bytes(count);
    bytes.resize(stream.read(bytes, timeout).value());
    return bytes;
  }

  std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> ends = memoryStreams("robot");
  ByteStream& here = *ends.first;
  ByteStream& there = *ends.second;
  std::array<std::uint8_t, 8> room{};
};

TEST_F(MemoryStreamTest, whatIsWrittenAtOneEndIsReadAtTheOtherInPieces) {
  const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
  ASSERT_TRUE(here.write(bytes));
  EXPECT_THAT(read(there, 2), ElementsAre(1, 2));
  EXPECT_THAT(read(there, 2), ElementsAre(3));
  EXPECT_THAT(read(there, 2), ElementsAre());
  EXPECT_THAT(read(here, 2), ElementsAre());
}

TEST_F(MemoryStreamTest, aReaderThatWaitsIsWokenByBytesOfAnotherThread) {
  std::jthread writer([&] { EXPECT_TRUE(here.write(std::array<std::uint8_t, 1>{9})); });
  EXPECT_THAT(read(there, 4, 10s), ElementsAre(9));
}

TEST_F(MemoryStreamTest, whatIsUnderWayIsReadBeforeTheEnd) {
  ASSERT_TRUE(here.write(std::array<std::uint8_t, 2>{1, 2}));
  ends.first.reset();
  EXPECT_THAT(read(there, 8), ElementsAre(1, 2));
  EXPECT_EQ(there.read(room, 0ms).error().id, "stream.lost");
  EXPECT_EQ(there.write(room).error().id, "stream.lost");
}

TEST_F(MemoryStreamTest, closingWakesWhoReads) {
  std::jthread closer([&] { here.close(); });
  EXPECT_EQ(here.read(room, 10s).error().id, "stream.closed");
  closer.join();
  EXPECT_EQ(here.write(room).error().id, "stream.closed");
  EXPECT_EQ(there.read(room, 10s).error().id, "stream.lost");
}

TEST_F(MemoryStreamTest, aReaderThatNeverReadsCostsBoundedMemory) {
  const std::vector<std::uint8_t> half(kMemoryStreamBytes / 2 + 1);
  ASSERT_TRUE(here.write(half));
  EXPECT_EQ(here.write(half).error().id, "stream.busy");
  EXPECT_EQ(read(there, kMemoryStreamBytes).size(), half.size());
  EXPECT_TRUE(here.write(half));
}

}  // namespace
}  // namespace robotlink::arcos
