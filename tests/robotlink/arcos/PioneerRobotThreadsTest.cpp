// SPDX-License-Identifier: GPL-3.0-or-later
// The robot object over real lines, called by several threads. ThreadSanitizer's task, too.
#include <gmock/gmock.h>

#include <thread>

#include "robotlink/arcos/PioneerRobot.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/arcos/IdealRobot.h"
#include "tests/robotlink/arcos/PseudoTerminal.h"
#include "tests/robotlink/arcos/stream/MemoryStream.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

/// A robot in a thread of its own and in real time, at the end of a line in memory.
class RobotInMemory {
 public:
  RobotInMemory()
      : ends_(memoryStreams("robot")), thread_([this](const std::stop_token& stop) { run(stop); }) {}
  std::unique_ptr<ByteStream> clientEnd() { return std::move(ends_.first); }
  bool clientLeft() const { return left_; }
  /// From now on it sends nothing.
  void fallSilent() { silent_ = true; }

 private:
  void run(const std::stop_token& stop) {
    IdealRobot robot;
    PacketParser parser;
    const SteadyClock clock;
    std::array<std::uint8_t, 512> bytes{};
    while (!stop.stop_requested()) {
      const auto count = ends_.second->read(bytes, 2ms);
      if (!count) break;
      parser.push(std::span(bytes).first(*count));
      while (const auto found = parser.next()) robot.send(std::get<Packet>(*found));
      while (robot.now < clock.now()) robot.step();
      Bytes out;
      for (const Packet& packet : robot.received) append(packet, out);
      robot.forget();
      if (!silent_ && !ends_.second->write(out)) break;
    }
    left_ = true;
  }

  std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> ends_;
  std::atomic<bool> left_{false}, silent_{false};
  std::jthread thread_;
};

TEST(PioneerRobotThreads, allThreadsMayCallEverything) {
  RobotInMemory far;
  PioneerRobot robot([&]() -> Result<std::unique_ptr<ByteStream>> { return far.clientEnd(); },
                     std::make_shared<SteadyClock>());
  const auto begun = robot.begin();
  ASSERT_TRUE(begun) << begun.error().text;
  std::atomic<int> states = 0, sent = 0;
  {
    const auto reader = [&](const std::stop_token& stop) {
      while (!stop.stop_requested()) states += robot.read(50ms).value_or(false) ? 1 : 0;
    };
    const auto driver = [&](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        const int seen = states;
        for (int i = 0; i < 5; ++i) sent += robot.drive(0.1, 0.1) ? 1 : 0;
        while (states == seen && !stop.stop_requested()) std::this_thread::yield();
      }
    };
    const auto looker = [&](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        const double battery = robot.battery() + robot.sonar(3) + robot.nearestEcho(-1, 1);
        EXPECT_GT(battery, 0);
        std::this_thread::yield();
      }
    };
    robot.setMotors(true);
    robot.setSonar(true);
    robot.setLaser(true);
    const std::jthread a(reader), b(reader), c(driver), d(looker);
    EXPECT_TRUE(eventually([&] { return states >= 4 && sent >= 20; }));
  }
  EXPECT_EQ(robot.linkCounts().checksumErrors, 0u);
  EXPECT_GT(robot.speed(), 0.01);
}

TEST(PioneerRobotThreads, commandsDoNotWaitForAReadThatWaits) {
  RobotInMemory far;
  PioneerRobot robot([&]() -> Result<std::unique_ptr<ByteStream>> { return far.clientEnd(); },
                     std::make_shared<SteadyClock>());
  ASSERT_TRUE(robot.begin());
  std::atomic<int> begun{0}, ended{0};
  const std::jthread reader([&](const std::stop_token& stop) {
    while (!stop.stop_requested() && robot.isConnected()) {
      ++begun;
      robot.read(1h);
      ++ended;
    }
  });
  ASSERT_TRUE(eventually([&] { return ended > 0; }));
  far.fallSilent();
  const int before = begun;
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(robot.setSpeed(0));
  EXPECT_LE(begun - before, 2) << "what was on its way may still have been read";
  robot.end();
}

TEST(PioneerRobotThreads, endingWakesWhoReads) {
  RobotInMemory far;
  PioneerRobot robot([&]() -> Result<std::unique_ptr<ByteStream>> { return far.clientEnd(); },
                     std::make_shared<SteadyClock>());
  ASSERT_TRUE(robot.begin());
  std::jthread ender([&] { robot.end(); });
  Result<bool> read = true;
  while (read) read = robot.read(5s);
  EXPECT_FALSE(robot.isConnected());
  ender.join();
  EXPECT_TRUE(eventually([&] { return far.clientLeft(); }));
}

}  // namespace
}  // namespace robotlink::arcos
