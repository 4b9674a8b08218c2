// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/PioneerClient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

/// Notes what is reported to it.
struct Witness : PioneerClient::Listener {
  void packetPassed(Direction direction, const Packet& packet, std::span<const std::uint8_t> frame,
                    Instant) override {
    passed.push_back((direction == Direction::kFromRobot ? "robot " : "client ") + std::to_string(packet.id) +
                     (frame.empty() ? "" : " " + toHex(frame)));
  }
  void damageCame(const DamagedBytes& damage, Instant) override { damages.push_back(toHex(damage.bytes)); }
  void robotIdentified() override { events += "identified "; }
  void configurationCame(const Configuration&) override { events += "configuration "; }
  void stateCame(const StandardInformation& information, Instant) override {
    events += "state ";
    informationXMm = information.xMm;
  }
  void scanCame(const RangeScan&) override { events += "scan "; }
  void connectionChanged(bool connected, Instant) override { events += connected ? "connected " : "lost "; }

  std::string events;
  std::vector<std::string> passed, damages;
  int informationXMm = 0;
};

Packet identity(const std::string& name = "MobileSim") {
  Identity identity;
  identity.name = name;
  identity.subclass = "p3at-sh";
  return toPacket(identity);
}

Packet at(int xMm, int yMm = 0, int heading4096 = 0) {
  StandardInformation information;
  information.xMm = static_cast<std::int16_t>(xMm);
  information.yMm = static_cast<std::int16_t>(yMm);
  information.heading4096 = static_cast<std::int16_t>(heading4096);
  return toPacket(information);
}

LaserPacket scanPart(std::uint16_t first, std::size_t count, std::uint16_t total) {
  LaserPacket part;
  part.total = total;
  part.first = first;
  part.readings.resize(count, {.rangeMm = 2000, .reflectance = 0, .reserved = {}});
  return part;
}

struct PioneerClientTest : testing::Test {
  void pass(Duration time = 100ms) {
    now += time;
    client.tick(now);
  }
  /// The handshake, with packets as values.
  void connect() {
    client.open(now);
    client.linkOpened(now);
    client.take(Packet{0, {}}, now);
    client.take(Packet{1, {}}, now);
    client.take(identity(), now);
    pass();
    client.take(toPacket(Configuration{}), now);
    client.take(at(0), now);
    pass();
    ASSERT_TRUE(client.isConnected());
    client.takeOutgoing(now);
    witness = {};
  }

  Instant now = Instant(1s);
  Witness witness;
  PioneerClient client{witness};
};

TEST_F(PioneerClientTest, whatHappensIsReportedInItsOrder) {
  client.open(now);
  client.linkOpened(now);
  client.take(Packet{0, {}}, now);
  client.take(Packet{1, {}}, now);
  client.take(identity(), now);
  pass();
  client.take(toPacket(Configuration{}), now);
  client.take(at(300), now);
  EXPECT_EQ(witness.events, "identified configuration state ");
  EXPECT_EQ(witness.informationXMm, 300);
  pass();
  EXPECT_EQ(witness.events, "identified configuration state connected ");
  EXPECT_TRUE(client.isSimulated());
  EXPECT_NEAR(client.state().pose.x, 0.3, 1e-9);
  pass(20s);
  EXPECT_EQ(witness.events, "identified configuration state connected lost ");
}

TEST_F(PioneerClientTest, bytesThatCameAndGoAreShownAsTheyAre) {
  connect();
  const Bytes bytes = encode(at(100));
  Bytes line{0x01, 0x02};
  line.insert(line.end(), bytes.begin(), bytes.end());
  client.take(std::span(line).first(9), now);
  client.take(std::span(line).subspan(9), now);
  EXPECT_THAT(witness.damages, ElementsAre("0102"));
  EXPECT_THAT(witness.passed, ElementsAre("robot 50 " + toHex(bytes)));
  witness.passed.clear();
  ASSERT_TRUE(client.send(command(CommandId::kVel, 250), now));
  const auto frames = client.takeOutgoingFrames(now);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(toHex(frames[0]), "fafb060b3bfa00053b");
  EXPECT_THAT(witness.passed, ElementsAre("client 11 " + toHex(frames[0])));
}

TEST_F(PioneerClientTest, packetsThatAreHandedOverAsValuesHaveNoBytes) {
  connect();
  client.take(at(100), now);
  ASSERT_TRUE(client.send(command(CommandId::kVel, 250), now));
  EXPECT_THAT(client.takeOutgoing(now), ElementsAre(toPacket(command(CommandId::kVel, 250))));
  EXPECT_THAT(witness.passed, ElementsAre("robot 50", "client 11"));
}

TEST_F(PioneerClientTest, whatAnotherClientHearsCountsAndIsNotAnswered) {
  connect();
  client.close(now);
  client.dropOutgoing();
  pass();
  witness = {};
  client.overhear(toPacket(command(CommandId::kVel, 250)), Direction::kFromClient, now);
  client.overhear(identity("Rosie"), Direction::kFromRobot, now);
  client.overhear(at(32700), Direction::kFromRobot, now);
  client.overhear(at(32700 + 100 - 65536), Direction::kFromRobot, now);
  client.overhear(toPacket(scanPart(0, 3, 3)), Direction::kFromRobot, now);
  EXPECT_EQ(witness.events, "identified state state scan ");
  EXPECT_NEAR(client.state().pose.x, 32.8, 1e-9);
  EXPECT_EQ(witness.passed.size(), 5U);
  EXPECT_EQ(client.session().identity()->name, "Rosie");
  EXPECT_FALSE(client.isConnected());
  EXPECT_THAT(client.takeOutgoing(now), IsEmpty());
}

TEST_F(PioneerClientTest, aScanHasThePoseAndTheAnglesThatItWasTakenWith) {
  connect();
  ASSERT_TRUE(client.startLaser(radians(-45.0), radians(45.0), PioneerClient::LaserCommands::kUsual, now));
  client.take(at(1000, 0, 1024), now);
  client.take(toPacket(scanPart(0, 32, 64)), now);
  client.take(at(1500, 0, 1024), now);
  client.take(toPacket(scanPart(32, 32, 64)), now);
  ASSERT_TRUE(client.scan());
  EXPECT_NEAR(client.scan()->robot.x, 1.0, 1e-9) << "where it was when the scan began";
  EXPECT_NEAR(client.scan()->robot.heading, kPi / 2, 1e-3);
  EXPECT_NEAR(client.scan()->angle(0), radians(-45.0), 1e-9);
  EXPECT_NEAR(client.scan()->angle(63), radians(45.0), 1e-9);
  ASSERT_TRUE(client.stopLaser(now));
  EXPECT_FALSE(client.scan());
}

TEST_F(PioneerClientTest, aPlainScanBringsItsPoseAlongWhichDoesNotWrapEither) {
  connect();
  for (const int xMm : {10000, 20000, 30000, 32750}) client.take(at(xMm), now);
  LaserPacket plain = scanPart(0, 5, 5);
  plain.extended = false;
  plain.xMm = static_cast<std::int16_t>(32800 - 65536);
  plain.headingDeg = 90;
  client.take(toPacket(plain), now);
  ASSERT_TRUE(client.scan());
  EXPECT_NEAR(client.scan()->robot.x, 32.8, 1e-9);
  EXPECT_NEAR(client.scan()->robot.heading, kPi / 2, 1e-9);
}

TEST_F(PioneerClientTest, aPacketWhoseRestNeverComesIsGivenUp) {
  connect();
  const Bytes bytes = encode(at(100));
  client.take(std::span(bytes).first(9), now);
  client.lineSilent(50ms);
  client.take(std::span(bytes).subspan(9), now);
  EXPECT_EQ(client.received().packets, 1U);
  client.take(std::span(bytes).first(9), now);
  client.lineSilent(100ms);
  client.take(bytes, now);
  EXPECT_EQ(client.received().packets, 2U);
  EXPECT_EQ(client.received().skippedBytes, 9U);
}

}  // namespace
}  // namespace robotlink::arcos
