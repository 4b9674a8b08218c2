// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of ArcosAcceptanceTest that are about driving and sensing: C9 to C13. Clients are those of the
// recordings, in their behavior.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/app/arcos/ArcosBench.h"
#include "tests/robotlink/arcos/Recordings.h"

namespace app {
namespace {

using namespace robotlink;
using namespace robotlink::arcos;
using testing::SizeIs;
using Sip = StandardInformation;

const std::string kRoom = ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf";
const std::string kWallAhead =
    "<model name=\"wall\"><static>true</static><pose>1.5 0 0.5 0 0 0</pose><link name=\"wall\"><collision "
    "name=\"wall\"><geometry>"
    "<box><size>0.2 6 1</size></box></geometry></collision><visual name=\"wall\"><geometry><box><size>0.2 6 "
    "1</size></box></geometry>"
    "</visual></link></model>";

/// Counts on what wraps, as clients do: differences of more than half of the range went the other way.
class Unwrapped {
 public:
  explicit Unwrapped(int range) : range_(range) {}
  void add(int value) {
    if (last_) {
      int step = (value - *last_) % range_;
      if (step > range_ / 2) step -= range_;
      if (step < -range_ / 2) step += range_;
      sum_ += step;
      largest_ = std::max(largest_, std::abs(step));
    }
    last_ = value;
  }
  int sum() const { return sum_; }
  int largest() const { return largest_; }

 private:
  const int range_;
  std::optional<int> last_;
  int sum_ = 0, largest_ = 0;
};

double headingOf(const Sip& sip) {
  return sip.heading4096 * 2 * kPi / 4096;
}

TEST(ArcosDriving, c9SixteenSonarsBatteryAndStall) {
  ArcosBench bench(kWallAhead);
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  bench.run(0.7);
  std::map<int, int> ranges;
  for (const Sip& sip : client.information()) {
    for (const auto& sonar : sip.sonars) ranges[sonar.number] = sonar.rangeMm;
  }
  ASSERT_THAT(ranges, SizeIs(16));
  EXPECT_NEAR(ranges[3], 1400 - 245, 40) << "to the wall";
  EXPECT_NEAR(ranges[4], 1400 - 245, 40);
  for (int rear = 8; rear < 16; ++rear) EXPECT_EQ(ranges[rear], 5000) << rear;
  const Sip before = client.latest();
  EXPECT_TRUE(before.motorsOn());
  EXPECT_GE(before.batteryDecivolts, 120);
  EXPECT_LE(before.batteryDecivolts, 130);
  EXPECT_EQ(before.chargeState, 0);
  EXPECT_FALSE(before.leftStalled() || before.rightStalled());
  client.send(CommandId::kVel, 300);
  for (int i = 0; i < 80 && !(client.latest().leftStalled() && client.latest().rightStalled()); ++i) {
    bench.drive(0.1);
  }
  EXPECT_TRUE(client.latest().leftStalled() && client.latest().rightStalled());
  EXPECT_NE(client.latest().frontBumpers(), 0U);
  client.send(CommandId::kVel, -200);
  bench.drive(2);
  EXPECT_FALSE(client.latest().leftStalled() || client.latest().rightStalled()) << "cleared afterwards";
  EXPECT_EQ(client.latest().frontBumpers(), 0U);
  EXPECT_LT(client.latest().leftSpeedMmS, -150);
}

TEST(ArcosDriving, c10LaserByTheOldCommandsAndTheNew) {
  ArcosBench bench(kWallAhead);
  for (const auto& ids : {std::array{36, 37, 38, 35}, std::array{231, 232, 233, 230}}) {
    WireClient& client = bench.connect();
    client.handshake();
    const std::array arguments{-90, 90, 100, 2};
    for (std::size_t i = 0; i < 4; ++i) client.send(static_cast<CommandId>(ids[i]), arguments[i]);
    bench.drive(2.05);
    const auto parts = client.of(LaserPacket::kExtendedId);
    ASSERT_THAT(parts, SizeIs(120)) << "six after each information packet";
    int next = 0;
    double ahead = 0;
    for (const Packet& packet : parts) {
      const auto part = decode<LaserPacket>(packet);
      ASSERT_TRUE(part);
      EXPECT_EQ(part->total, 181);
      ASSERT_EQ(part->first, next);
      next += static_cast<int>(part->readings.size());
      if (part->first <= 90 && next > 90) ahead = part->readings[90U - part->first].rangeMm;
      if (next == 181) next = 0;
    }
    EXPECT_EQ(next, 0);
    EXPECT_NEAR(ahead, 1400 - 125, 30) << "reading 90 looks ahead";
    client.close();
    bench.run(0.1);
  }
}

TEST(ArcosDriving, c11OdometryWrapsUnseenByClients) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  client.send(CommandId::kSetV, 1000);
  client.send(CommandId::kSetA, 1000);
  client.send(CommandId::kVel, 1000);
  bench.drive(38);
  Unwrapped sixteen(65536), fifteen(32768), twelve(4096);
  int lowest = 0;
  for (const Sip& sip : client.information()) {
    sixteen.add(sip.xMm);
    fifteen.add(sip.xMm & 0x7FFF);  // ARIA
    twelve.add(sip.xMm & 0xFFF);    // p2os
    lowest = std::min<int>(lowest, sip.xMm);
  }
  EXPECT_LT(lowest, -30000) << "it has wrapped";
  const double truth = bench.world().simulation().modelPose("p3at1")->translation().x() * 1000;
  EXPECT_GT(truth, 33000);
  for (const Unwrapped& counted : {sixteen, fifteen, twelve}) EXPECT_NEAR(counted.sum(), truth, 0.01 * truth);
  EXPECT_LE(twelve.largest(), 105) << "at 1 m/s";
  client.send(CommandId::kSetO);
  bench.run(0.05);
  client.send(CommandId::kStop);
  bench.run(0.1);
  EXPECT_LT(std::abs(client.latest().xMm), 200) << "SETO zeroes";
}

/// The client half of a conversation, said at the times of its file. Returns whether there is one.
bool replay(ArcosBench& bench, WireClient& client, const std::string& source, const std::string& name) {
  const auto found = conversation(source, name);
  if (!found) return false;
  const Instant begin = bench.now();
  for (const auto& event : found->events) {
    while (bench.now() < begin + event.at) bench.step();
    if (event.kind == Conversation::Kind::kPacket && event.direction == Direction::kFromClient)
      client.send(event.bytes);
  }
  return true;
}

/// The wheels skid, and yet the track that the odometry goes by is about right.
void expectTruthNear(ArcosBench& bench, const Sip& odometry) {
  const auto truth = robotlink::groundPose(*bench.world().simulation().modelPose("p3at1"));
  EXPECT_NEAR(truth.x * 1000, odometry.xMm, 80);
  EXPECT_NEAR(truth.y * 1000, odometry.yMm, 80);
}

TEST(ArcosDriving, c12SimpleMotionCommandsEndNearTheReference) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  if (!replay(bench, client, "real", "simpleMotionCommands"))
    GTEST_SKIP() << "there are no recordings in ../shared/data/arcos/wire";
  const auto information = client.information();
  ASSERT_GT(information.size(), 290U);
  EXPECT_NEAR(information[120].xMm, 1250, 60);
  int leftmost = 0;
  for (const Sip& sip : information) leftmost = std::max<int>(leftmost, sip.heading4096);
  EXPECT_NEAR(leftmost, 560, 40);
  const Sip& last = information.back();
  EXPECT_NEAR(last.xMm, 1703, 80);
  EXPECT_NEAR(last.yMm, -540, 80);
  expectTruthNear(bench, last);
}

TEST(ArcosDriving, c12AMadeClientsCommandsEndWhereTheyLead) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  ASSERT_TRUE(replay(bench, client, "made", "drive"));
  const auto information = client.information();
  ASSERT_GT(information.size(), 105U);
  EXPECT_NEAR(information[58].xMm, 1000, 60);
  const Sip& last = information.back();
  EXPECT_NEAR(last.heading4096, 512, 40);
  EXPECT_NEAR(last.xMm, 1280, 80);
  EXPECT_NEAR(last.yMm, 280, 80);
  expectTruthNear(bench, last);
}

TEST(ArcosDriving, c12ThreeGoalsAreReachedInThirtySeconds) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  bench.run(0.2);
  const std::array<Vector2, 4> goals{Vector2(2.5, 0), Vector2(2.5, 2.5), Vector2(0, 2.5), Vector2(0, 0)};
  std::size_t goal = 0;
  for (const auto end = bench.now() + std::chrono::seconds(30); bench.now() < end && goal < goals.size();
       bench.run(0.1)) {
    const Sip sip = client.latest();
    const Vector2 way = goals[goal] - Vector2(sip.xMm / 1000.0, sip.yMm / 1000.0);
    if (way.norm() < 0.2) ++goal;
    const double bearing = std::atan2(way.y(), way.x());
    const double error = std::abs(normalizedAngle(bearing - headingOf(sip)));
    client.send(CommandId::kHead, static_cast<int>(std::lround(degrees(bearing))));
    client.send(CommandId::kVel, error > radians(30.0) ? 0 : 400);
  }
  EXPECT_GE(goal, 3U);
}

TEST(ArcosDriving, c12WanderingDoesNotEndInALoopOfStalls) {
  ArcosBench bench(kRoom, 0);
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  bench.run(0.5);
  std::map<int, int> ranges;
  int stalls = 0;
  double recovering = 0;
  bool stalledBefore = false;
  for (const auto end = bench.now() + std::chrono::seconds(60); bench.now() < end; bench.run(0.1)) {
    const Sip sip = client.latest();
    for (const auto& sonar : sip.sonars) ranges[sonar.number] = sonar.rangeMm;
    const bool stalled = sip.leftStalled() || sip.rightStalled();
    stalls += stalled && !stalledBefore;
    stalledBefore = stalled;
    if (stalled) recovering = 1.5;
    recovering -= 0.1;
    const int front = std::min({ranges[2], ranges[3], ranges[4], ranges[5]});
    const int left = std::min(ranges[1], ranges[2]), right = std::min(ranges[5], ranges[6]);
    if (recovering > 0) {
      client.send(CommandId::kVel, -150);
      client.send(CommandId::kRvel, 30);
    } else {
      client.send(CommandId::kVel, front < 700 ? 0 : std::min(400, front / 3));
      client.send(CommandId::kRvel, front < 1000 ? (left > right ? 40 : -40) : 0);
    }
  }
  EXPECT_LE(stalls, 3);
  double traveled = 0;
  const auto information = client.information();
  for (std::size_t i = 1; i < information.size(); ++i) {
    traveled +=
        std::hypot(information[i].xMm - information[i - 1].xMm, information[i].yMm - information[i - 1].yMm);
  }
  EXPECT_GT(traveled, 5000);
}

TEST(ArcosDriving, c13SilenceStopsAndTheNextPacketResumes) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  client.send(CommandId::kVel, 200);
  bench.drive(5);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 200, 10) << "pulses alone keep it going";
  client.send(CommandId::kPulse);
  bench.run(1.9);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 200, 10);
  bench.run(1.5);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 0, 5);
  client.send(CommandId::kPulse);
  bench.run(1.2);
  EXPECT_NEAR(client.latest().leftSpeedMmS, 200, 10);
}

TEST(ArcosDriving, aClientThatGoesStopsItsRobotAndLeavesTheOthers) {
  ArcosBench bench("<include><uri>model://p3at</uri><name>p3at2</name><pose>0 3 0 0 0 0</pose></include>");
  WireClient& first = bench.connect(0);
  WireClient& second = bench.connect(1);
  for (WireClient* client : {&first, &second}) {
    client->handshake();
    client->send(CommandId::kEnable, 1);
    client->send(CommandId::kVel, 200);
  }
  bench.drive(2);
  first.close();
  bench.drive(2);
  EXPECT_FALSE(bench.world().pioneers()[0]->session().motion().motorsOn());
  EXPECT_NEAR(second.latest().leftSpeedMmS, 200, 10);
  const auto place = [&] {
    return bench.world().simulation().modelPose(bench.world().pioneers()[0]->robot())->translation().x();
  };
  const double x = place();
  bench.drive(1);
  EXPECT_NEAR(place(), x, 1e-3);
}

TEST(ArcosDriving, aSlowSimulationStopsWhileItWaitsForItsNextStep) {
  ArcosSimulation::Options options;
  options.scene = kRoom;
  options.speed = 0.004;  // two seconds a step
  options.ports.firstPort = 0;
  auto simulation = ArcosSimulation::create(options, [](const std::string&) {});
  ASSERT_TRUE(simulation) << describe(simulation.error());
  int asked = 0;
  (*simulation)->run(Instant::max(), [&asked] { return ++asked == 4; });
  EXPECT_EQ((*simulation)->world().clock().now(), Instant(SimulatedWorld::kStep));
}

TEST(ArcosDriving, theWorldsResetKeepsTheClientConnected) {
  ArcosBench bench;
  WireClient& client = bench.connect();
  client.handshake();
  client.send(CommandId::kEnable, 1);
  client.send(CommandId::kVel, 300);
  bench.drive(3);
  EXPECT_GT(client.latest().xMm, 400);
  bench.world().reset(7);
  client.forget();
  bench.drive(2);
  EXPECT_EQ(client.information().size(), 20U);
  EXPECT_NEAR(client.latest().xMm, 0, 2) << "it stands where it began";
  client.send(CommandId::kVel, 300);
  bench.drive(2);
  EXPECT_GT(client.latest().xMm, 150);
}

TEST(ArcosDriving, tiresThatAreNotRoundMakeTheOdometryErrTheSameWayForASeed) {
  const auto drive = [](std::uint64_t seed) {
    SimulatedWorld::Options world;
    world.seed = seed;
    ArcosBench bench({}, world);
    WireClient& client = bench.connect();
    client.handshake();
    client.send(CommandId::kEnable, 1);
    client.send(CommandId::kVel, 500);
    bench.drive(6);
    return client.latest();
  };
  EXPECT_EQ(drive(1), drive(1));
  EXPECT_NE(drive(1).heading4096, drive(2).heading4096);
}

}  // namespace
}  // namespace app
