// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/RobotPorts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "robotlink/arcos/stream/OpenStream.h"

namespace {

using namespace robotlink;
using namespace robotlink::arcos;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Clock = std::chrono::steady_clock;

class RobotPortsTest : public testing::Test, public RobotPorts::Listener {
 protected:
  std::unique_ptr<RobotPorts> ports;
  std::map<std::size_t, std::vector<Packet>> packets;
  std::map<std::size_t, int> came, gone;

  /// The clock that measures how long clients are silent; only tests move it.
  Clock::time_point now = Clock::now();

  RobotPortsTest() {
    auto opened = RobotPorts::open({"127.0.0.1", 0, 2, 10s, [this] { return now; }});
    if (opened) ports = std::move(*opened);
  }
  void SetUp() override { ASSERT_TRUE(ports); }

  void clientCame(std::size_t robot, const std::string&) override { ++came[robot]; }
  void packetCame(std::size_t robot, const Packet& packet) override { packets[robot].push_back(packet); }
  void clientGone(std::size_t robot) override { ++gone[robot]; }

  std::unique_ptr<ByteStream> connect(std::size_t robot) {
    auto stream = open("tcp://127.0.0.1:" + std::to_string(ports->port(robot)));
    EXPECT_TRUE(stream) << (stream ? "" : stream.error().text);
    return stream ? std::move(*stream) : nullptr;
  }
  /// Serves until something is so, but not for ever.
  template <typename Condition>
  bool serveUntil(Condition condition) {
    for (const auto end = Clock::now() + 5s; Clock::now() < end && !condition();)
      ports->serve(*this, Clock::now() + 1ms);
    return condition();
  }
  static Bytes readAll(ByteStream& stream, std::size_t count) {
    Bytes bytes(count);
    std::size_t had = 0;
    while (had < count) {
      const auto read = stream.read({bytes.data() + had, count - had}, 2s);
      if (!read || *read == 0) break;
      had += *read;
    }
    bytes.resize(had);
    return bytes;
  }
};

TEST_F(RobotPortsTest, packetsGoBothWays) {
  const auto client = connect(1);
  ASSERT_TRUE(client->write(encode({11, {0x3B, 1, 2}})));
  ASSERT_TRUE(serveUntil([&] { return !packets[1].empty(); }));
  EXPECT_EQ(packets[1][0], (Packet{11, {0x3B, 1, 2}}));
  EXPECT_EQ(came[1], 1);
  EXPECT_THAT(ports->statistics(1).client, HasSubstr("127.0.0.1:"));
  const std::vector<Packet> answer = {{2, {1}}, {3, {}}};
  ports->send(1, answer);
  ports->send(0, answer);  // to nobody
  Bytes expected = encode(answer[0]);
  append(answer[1], expected);
  EXPECT_EQ(readAll(*client, expected.size()), expected);
}

TEST_F(RobotPortsTest, aPortIsFreeAtOnceWhenItsClientGoes) {
  for (int i = 1; i <= 20; ++i) {
    const auto client = connect(0);
    ASSERT_TRUE(client->write(encode({0, {}})));
    ASSERT_TRUE(serveUntil([&] { return packets[0].size() == static_cast<std::size_t>(i); })) << i;
  }
  EXPECT_EQ(came[0], 20);
  EXPECT_EQ(ports->statistics(0).clients, 20U);
  EXPECT_EQ(ports->statistics(0).refused, 0U);
  ASSERT_TRUE(serveUntil([&] { return gone[0] == 20; }));
}

TEST_F(RobotPortsTest, aClientThatLeavesBytesUnreadIsGone) {
  {
    const auto client = connect(0);
    ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
    ports->send(0, std::vector<Packet>(10, {0x32, Bytes(80)}));
  }
  const auto next = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 2; }));
  EXPECT_EQ(gone[0], 1);
}

TEST_F(RobotPortsTest, aSecondClientIsClosedAtOnceAndDisturbsNobody) {
  const auto first = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
  const auto second = connect(0);
  ASSERT_TRUE(second->write(encode({7, {}})));
  ASSERT_TRUE(serveUntil([&] { return ports->statistics(0).refused == 1; }));
  std::array<std::uint8_t, 8> bytes{};
  const auto read = second->read(bytes, 2s);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().id, "stream.lost");
  ASSERT_TRUE(first->write(encode({8, {}})));
  ASSERT_TRUE(serveUntil([&] { return !packets[0].empty(); }));
  EXPECT_THAT(packets[0], testing::ElementsAre(Packet{8, {}}));
  EXPECT_EQ(gone[0], 0);
}

TEST_F(RobotPortsTest, aClientWhoseMachineHasGoneGivesWayToTheNext) {
  const auto first = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
  now += 9'999ms;
  const auto refused = connect(0);
  ASSERT_TRUE(serveUntil([&] { return ports->statistics(0).refused == 1; })) << "it may still be there";
  now += 1ms;
  const auto second = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 2; }));
  EXPECT_EQ(gone[0], 1);
  ASSERT_TRUE(second->write(encode({8, {}})));
  ASSERT_TRUE(serveUntil([&] { return !packets[0].empty(); }));
}

TEST_F(RobotPortsTest, damageIsCountedAndTheNextPacketsAreRead) {
  const auto client = connect(0);
  Bytes bytes = {1, 2, 3, 0xFA, 0xFB, 3, 9, 9, 9};
  append({5, {}}, bytes);
  for (const std::uint8_t byte : bytes) ASSERT_TRUE(client->write(std::span(&byte, 1)));
  ASSERT_TRUE(serveUntil([&] { return !packets[0].empty(); }));
  EXPECT_EQ(packets[0][0], (Packet{5, {}}));
  EXPECT_EQ(ports->statistics(0).received.checksumErrors, 1U);
}

TEST_F(RobotPortsTest, aPacketWhoseRestNeverComesDoesNotSwallowTheNext) {
  const auto client = connect(0);
  ASSERT_TRUE(client->write(Bytes{0xFA, 0xFB, 100, 1, 2}));
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
  ASSERT_TRUE(serveUntil([&] { return ports->statistics(0).receivedBytes == 5; }));
  now += 130ms;
  ports->serve(*this, now);
  ASSERT_TRUE(client->write(encode({5, {}})));
  ASSERT_TRUE(serveUntil([&] { return !packets[0].empty(); }));
  EXPECT_EQ(packets[0][0], (Packet{5, {}}));
}

TEST_F(RobotPortsTest, aClientThatDoesNotReadLosesWholePacketsTheOldestOnes) {
  const auto client = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
  constexpr std::uint32_t kPackets = 100'000;
  for (std::uint32_t i = 0; i < kPackets; ++i) {
    Packet packet{0x61, Bytes(180, 0x55)};
    for (unsigned byte = 0; byte < 4; ++byte) packet.data[byte] = static_cast<std::uint8_t>(i >> (8 * byte));
    ports->send(0, std::span(&packet, 1));
  }
  EXPECT_GT(ports->statistics(0).droppedPackets, kPackets / 2);
  // What was not dropped arrives whole, the newest with it.
  PacketParser parser;
  std::uint64_t read = 0;
  std::uint32_t newest = 0;
  Bytes bytes(1 << 14);
  for (const auto end = Clock::now() + 5s; Clock::now() < end && newest + 1 < kPackets;) {
    ports->serve(*this, Clock::now());
    const auto count = client->read(bytes, Duration(0));
    ASSERT_TRUE(count);
    parser.push(std::span(bytes).first(*count));
    while (const auto found = parser.next()) {
      ASSERT_TRUE(std::holds_alternative<Packet>(*found));
      const auto& data = std::get<Packet>(*found).data;
      newest = data[0] | (data[1] << 8U) | (data[2] << 16U);
      ++read;
    }
  }
  EXPECT_EQ(newest + 1, kPackets);
  EXPECT_EQ(ports->statistics(0).sentPackets, read);
  EXPECT_EQ(ports->statistics(0).sentPackets + ports->statistics(0).droppedPackets, kPackets);
}

TEST_F(RobotPortsTest, whoFloodsGetsABudgetAndTheOthersAreHeardInTheSameCall) {
  const auto flooder = connect(0), other = connect(1);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1 && came[1] == 1; }));
  Bytes flood;
  for (int i = 0; i < 1000; ++i) append({18, {}}, flood);
  ASSERT_TRUE(flooder->write(flood));
  ASSERT_TRUE(other->write(encode({0, {}})));
  for (std::size_t calls = 1; packets[0].size() < 1000 && calls < 100'000; ++calls) {
    const std::size_t before = packets[0].size();
    ports->serve(*this, {});
    ASSERT_LE(packets[0].size() - before, RobotPorts::kMaxPackets);
    if (before == 0 && !packets[0].empty()) {
      EXPECT_THAT(packets[1], SizeIs(1));
    }
  }
  EXPECT_THAT(packets[0], SizeIs(1000)) << "what is over the budget is taken later";
}

TEST_F(RobotPortsTest, garbageIsReadNoFasterThanItsBudgetAllows) {
  const auto client = connect(0);
  ASSERT_TRUE(serveUntil([&] { return came[0] == 1; }));
  ASSERT_TRUE(client->write(Bytes(100'000, 0xFA)));
  std::uint64_t before = 0;
  for (int calls = 0; before < 100'000 && calls < 100'000; ++calls) {
    ports->serve(*this, {});
    const std::uint64_t received = ports->statistics(0).receivedBytes;
    ASSERT_LE(received - before, RobotPorts::kMaxBytes);
    before = received;
  }
  EXPECT_EQ(before, 100'000U);
}

TEST_F(RobotPortsTest, aClientThatSendsMuchAndGoesIsStillObeyed) {
  {
    const auto client = connect(0);
    Bytes burst;
    for (int i = 0; i < 300; ++i) append({18, {}}, burst);
    ASSERT_TRUE(client->write(burst));
  }
  ASSERT_TRUE(serveUntil([&] { return gone[0] == 1; }));
  EXPECT_THAT(packets[0], SizeIs(300));
}

TEST_F(RobotPortsTest, whoConnectsAgainAndAgainIsAcceptedSomeTimesACall) {
  std::vector<std::unique_ptr<ByteStream>> clients;
  for (int i = 0; i < 40; ++i) clients.push_back(connect(0));
  std::uint64_t before = 0;
  ASSERT_TRUE(serveUntil([&] {
    const auto statistics = ports->statistics(0);
    const std::uint64_t answered = statistics.clients + statistics.refused;
    EXPECT_LE(answered - before, 4U);
    before = answered;
    return answered == 40;
  }));
}

TEST_F(RobotPortsTest, aPortThatIsTakenIsNamed) {
  const auto again = RobotPorts::open({"127.0.0.1", ports->port(0), 1});
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().text, HasSubstr("127.0.0.1:" + std::to_string(ports->port(0))));
  EXPECT_THAT(again.error().text, HasSubstr("choose another port"));
}

TEST(RobotPorts, addressesThatCannotBeAreRefused) {
  EXPECT_FALSE(RobotPorts::open({"nowhere", 0, 1}));
  EXPECT_FALSE(RobotPorts::open({"127.0.0.1", 65535, 2}));
}

TEST(RobotPorts, itSaysWhetherTheNetworkCanReachIt) {
  EXPECT_TRUE((*RobotPorts::open({"localhost", 0, 1}))->loopbackOnly());
  EXPECT_FALSE((*RobotPorts::open({"0.0.0.0", 0, 1}))->loopbackOnly());
}

}  // namespace
