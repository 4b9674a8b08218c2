// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/SendQueue.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/codec/PacketParser.h"

namespace {

using namespace robotlink::arcos;
using namespace std::chrono_literals;

/// What a client reads of a queue: the first bytes of the packets.
class Reader {
 public:
  void take(SendQueue& queue, std::size_t count) {
    count = std::min(count, queue.bytes().size());
    parser_.push(queue.bytes().first(count));
    queue.written(count);
    while (const auto found = parser_.next()) {
      ASSERT_TRUE(std::holds_alternative<Packet>(*found)) << "packets are dropped whole";
      read.push_back(std::get<Packet>(*found).data[0]);
    }
  }
  void takeAll(SendQueue& queue) { take(queue, queue.bytes().size()); }
  std::vector<int> read;

 private:
  PacketParser parser_;
};

Packet numbered(int number, std::size_t size = 80) {
  Packet packet{0x32, Bytes(size, 0x55)};
  packet.data[0] = static_cast<std::uint8_t>(number);
  return packet;
}

const SendQueue::Instant kStart{100s};

TEST(SendQueue, packetsAreReadInOrder) {
  SendQueue queue;
  for (int i = 0; i < 3; ++i) queue.push(numbered(i), kStart);
  Reader reader;
  reader.take(queue, 10);
  EXPECT_EQ(queue.sentPackets(), 0U);
  reader.takeAll(queue);
  EXPECT_EQ(reader.read, (std::vector{0, 1, 2}));
  EXPECT_EQ(queue.sentPackets(), 3U);
  EXPECT_EQ(queue.droppedPackets(), 0U);
}

TEST(SendQueue, aSlowReaderGetsNothingOlderThanASecond) {
  SendQueue queue;
  for (int i = 0; i < 40; ++i) queue.push(numbered(i), kStart + i * 100ms);
  queue.dropOld(kStart + 39 * 100ms);
  Reader reader;
  reader.takeAll(queue);
  EXPECT_EQ(reader.read.front(), 29);
  EXPECT_EQ(reader.read.back(), 39);
  EXPECT_EQ(queue.droppedPackets(), 29U);
}

TEST(SendQueue, aPacketWhoseBeginHasGoneOutIsNotDropped) {
  SendQueue queue;
  for (int i = 0; i < 3; ++i) queue.push(numbered(i), kStart + i * 100ms);
  Reader reader;
  reader.take(queue, 20);
  queue.push(numbered(3), kStart + 5s);
  queue.dropOld(kStart + 5s);
  reader.takeAll(queue);
  EXPECT_EQ(reader.read, (std::vector{0, 3}));
  EXPECT_EQ(queue.droppedPackets(), 2U);
}

TEST(SendQueue, itsSizeIsBoundedAndTheOldestGoFirst) {
  SendQueue queue;
  Reader reader;
  queue.push(numbered(0), kStart);
  reader.take(queue, 5);
  for (int i = 1; i < 250; ++i) {
    for (int j = 0; j < 10; ++j) queue.push(numbered(i, 180), kStart);
    ASSERT_LE(queue.bytes().size(), SendQueue::kMaxBytes);
  }
  reader.takeAll(queue);
  EXPECT_EQ(reader.read.front(), 0);
  EXPECT_GT(reader.read.at(1), 200);
  EXPECT_EQ(reader.read.back(), 249);
  EXPECT_EQ(queue.sentPackets() + queue.droppedPackets(), 2491U);
}

TEST(SendQueue, whatIsForgottenDoesNotDisturbTheNextClient) {
  SendQueue queue;
  queue.push(numbered(1), kStart);
  queue.push(numbered(2), kStart);
  Reader first, second;
  first.take(queue, 5);
  queue.clear();
  queue.push(numbered(3), kStart);
  second.takeAll(queue);
  EXPECT_EQ(second.read, (std::vector{3}));
}

}  // namespace
