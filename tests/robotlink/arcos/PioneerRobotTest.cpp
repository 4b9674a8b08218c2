// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/PioneerRobot.h"

#include <gmock/gmock.h>

#include "tests/robotlink/arcos/SimulatedLine.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A robot object and a simulated robot's microcontroller, joined by a line in which time stands still unless
/// somebody reads.
struct PioneerRobotTest : testing::Test {
  explicit PioneerRobotTest(ServerSettings settings = {}) : world(std::move(settings)) {}

  Result<std::unique_ptr<ByteStream>> open() {
    ++lines;
    if (world.unplugged) return failure("stream.no-device", "there is no cable");
    return std::make_unique<SimulatedLine>(world);
  }
  void begin() {
    const auto begun = robot.begin();
    ASSERT_TRUE(begun) << begun.error().text;
  }
  void readFor(double time) {
    for (const auto end = world.robot.now + fromSeconds(time); world.robot.now < end;)
      ASSERT_TRUE(robot.read());
  }

  SimulatedLine::World world;
  int lines = 0;
  // The world outlives the robot.
  PioneerRobot robot{[this] { return open(); },
                     std::shared_ptr<const Clock>(std::shared_ptr<void>(), &world.clock)};
};

TEST_F(PioneerRobotTest, itIsConnectedAndKnownAfterBegin) {
  EXPECT_FALSE(robot.isConnected());
  begin();
  EXPECT_TRUE(robot.isConnected());
  EXPECT_EQ(robot.name(), "MobileSim");
  EXPECT_EQ(robot.type().subclass, "p3at-sh");
  EXPECT_TRUE(robot.isSimulated());
  EXPECT_FALSE(robot.motorsOn());
  EXPECT_NEAR(robot.battery(), 12.8, 0.01);
  EXPECT_EQ(robot.problem(), "");
}

TEST_F(PioneerRobotTest, readReturnsWhetherTheStateIsNew) {
  begin();
  ASSERT_EQ(robot.read(), true) << "what begin() waited for was not read yet";
  EXPECT_EQ(robot.read(0ms), false);
  const Instant before = world.robot.now;
  EXPECT_EQ(robot.read(200ms), true);
  EXPECT_LE(world.robot.now - before, 101ms) << "it does not wait longer than it must";
  EXPECT_EQ(robot.read(30ms), false);
  EXPECT_LE(world.robot.now - before, 135ms);
}

TEST_F(PioneerRobotTest, readTakesTheLatestStateOfSeveral) {
  begin();
  robot.read();
  world.advance(450ms);
  EXPECT_EQ(robot.read(0ms), true);
  EXPECT_GE(robot.linkCounts().states, 5u);
  EXPECT_EQ(robot.read(0ms), false) << "older ones are not handed out one by one";
}

TEST_F(PioneerRobotTest, theRobotObeysCommands) {
  begin();
  robot.setMotors(true);
  robot.drive(0.3, radians(20.0));
  readFor(3);
  EXPECT_TRUE(robot.motorsOn());
  EXPECT_NEAR(robot.speed(), 0.3, 0.01);
  EXPECT_NEAR(robot.rotation(), radians(20.0), 0.02);
  robot.setRotation(0);
  robot.setSpeed(-0.1);
  readFor(3);
  EXPECT_NEAR(robot.speed(), -0.1, 0.01);
  EXPECT_NEAR(robot.rotation(), 0, 0.01);
  robot.setWheels(-0.1, 0.1);
  readFor(2);
  EXPECT_NEAR(robot.state().leftSpeed, -0.1, 0.01);
  EXPECT_NEAR(robot.state().rightSpeed, 0.1, 0.01);
  robot.stop();
  readFor(2);
  EXPECT_FALSE(robot.state().moving);
}

TEST_F(PioneerRobotTest, waysAndTurnsEndByThemselves) {
  begin();
  robot.setMotors(true);
  robot.resetOdometry();
  robot.move(-0.5);
  readFor(5);
  EXPECT_NEAR(robot.pose().x, -0.5, 0.02);
  robot.turn(radians(90.0));
  readFor(4);
  EXPECT_NEAR(robot.heading(), kPi / 2, 0.03);
  robot.turnTo(radians(-45.0));
  readFor(5);
  EXPECT_NEAR(robot.heading(), -kPi / 4, 0.03);
}

TEST_F(PioneerRobotTest, theEndOfAMotionIsWaitedFor) {
  begin();
  EXPECT_EQ(robot.waitForMotion().error().id, "pioneer.no-motion");
  robot.setMotors(true);
  robot.resetOdometry();
  robot.move(0.5);
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kArrived);
  EXPECT_NEAR(robot.pose().x, 0.5, 0.02);
  EXPECT_FALSE(robot.state().moving);
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kArrived) << "it has ended, who asks again hears the same";
  robot.turn(radians(-135.0));
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kArrived);
  EXPECT_NEAR(robot.heading(), radians(-135.0), 0.03);
  robot.turnTo(radians(170.0));
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kArrived);
  EXPECT_NEAR(robot.heading(), radians(170.0), 0.03);
}

TEST_F(PioneerRobotTest, aMotionThatDoesNotEndWhereItShouldSaysWhy) {
  begin();
  robot.move(1);
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kStopped) << "the motors are off";
  robot.setMotors(true);
  robot.move(5);
  EXPECT_EQ(robot.waitForMotion(1s), MotionEnd::kTimeout);
  world.robot.sensing.leftBlocked = world.robot.sensing.rightBlocked = true;
  EXPECT_EQ(robot.waitForMotion(), MotionEnd::kStalled);
  world.robot.sensing.leftBlocked = world.robot.sensing.rightBlocked = false;
  robot.move(5);
  world.unplugged = true;
  EXPECT_EQ(robot.waitForMotion().error().id, "stream.lost");
}

TEST_F(PioneerRobotTest, digitalOutputsAreSetOneByOne) {
  begin();
  robot.setDigitalOutputs(0xFF, 0);
  robot.setDigitalOutput(7, true);
  robot.setDigitalOutput(0, true);
  readFor(0.3);
  EXPECT_EQ(robot.digitalOutputs(), 0x81);
  robot.setDigitalOutputs(0xF0, 0x30);
  readFor(0.3);
  EXPECT_EQ(robot.digitalOutputs(), 0x31);
  EXPECT_EQ(robot.digitalInputs(), 0xFF);
  EXPECT_EQ(robot.setDigitalOutput(8, true).error().id, "pioneer.no-output");
  EXPECT_EQ(robot.selectAnalogInput(2).error().id, "pioneer.simulated");
}

TEST_F(PioneerRobotTest, anEmergencyStopIsFasterThanAStop) {
  begin();
  robot.setMotors(true);
  robot.setSpeed(0.5);
  readFor(3);
  robot.emergencyStop();
  readFor(0.2);
  EXPECT_NEAR(robot.speed(), 0, 0.01);
}

TEST_F(PioneerRobotTest, odometryIsResetWhereTheRobotIs) {
  begin();
  robot.setMotors(true);
  robot.setSpeed(0.3);
  readFor(5);
  ASSERT_GT(robot.pose().x, 1);
  robot.stop();
  readFor(2);
  robot.resetOdometry();
  readFor(0.3);
  EXPECT_NEAR(robot.pose().x, 0, 0.01);
}

TEST_F(PioneerRobotTest, readingKeepsTheWatchdogContentWithoutACommand) {
  begin();
  robot.setMotors(true);
  robot.setSpeed(0.2);
  readFor(6);
  EXPECT_NEAR(robot.speed(), 0.2, 0.01);
  EXPECT_GE(world.count(CommandId::kPulse), 8);
}

TEST_F(PioneerRobotTest, aProgramThatStopsCallingStopsTheRobotAfterTwoSeconds) {
  begin();
  robot.setMotors(true);
  robot.setSpeed(0.3);
  readFor(2);
  world.advance(1900ms);
  EXPECT_FALSE(world.robot.session.starved());
  world.advance(2s);
  EXPECT_TRUE(world.robot.session.starved());
  EXPECT_NEAR(world.robot.sensing.leftSpeed, 0, 0.001);
  world.advance(10s);
  EXPECT_TRUE(robot.setRotation(0)) << "a program that slept does not take its own silence for the robot's";
  EXPECT_FALSE(world.robot.session.starved());
  readFor(2);
  EXPECT_NEAR(robot.speed(), 0.3, 0.01) << "it goes on with its last command";
}

TEST_F(PioneerRobotTest, sonarsAreHeardOnceTheyAreOn) {
  begin();
  robot.setSonar(true);
  readFor(1);
  EXPECT_TRUE(robot.state().sonarOn);
  EXPECT_NEAR(robot.sonar(0), 1.0, 0.01);
  EXPECT_NEAR(robot.sonar(15), 2.5, 0.01);
  EXPECT_EQ(robot.sonar(99), 5.0) << "where there is no sonar nothing is known";
  ASSERT_EQ(robot.echoes().size(), 16u);
  EXPECT_NEAR(robot.nearestEcho(radians(80.0), radians(100.0)), std::hypot(0.147, 1.136), 0.01);
  EXPECT_EQ(robot.nearestEcho(3.141, 3.1415), std::numeric_limits<double>::infinity());
}

TEST_F(PioneerRobotTest, echoesStayWhereTheyWereWhileTheRobotMovesUntilTheyAreOld) {
  begin();
  robot.setSonar(true);
  robot.setMotors(true);
  robot.setSpeed(0.3);
  readFor(3);
  robot.setSonar(false);
  readFor(0.2);
  const Vector2 before = robot.echoes()[0];
  const double x = robot.pose().x;
  readFor(0.5);
  const double way = robot.pose().x - x;
  ASSERT_GT(way, 0.1);
  EXPECT_NEAR(robot.echoes()[0].x(), before.x() - way, 1e-6);
  EXPECT_NEAR(robot.echoes()[0].y(), before.y(), 1e-6);
  readFor(1);
  EXPECT_TRUE(robot.echoes().empty());
}

TEST_F(PioneerRobotTest, aSimulatedLaserIsScanned) {
  begin();
  EXPECT_FALSE(robot.laser());
  robot.setSonar(false);
  ASSERT_TRUE(robot.setLaser(true));
  readFor(1.5);
  const auto scan = robot.laser();
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->ranges.size(), 181u);
  EXPECT_NEAR(scan->ranges[90], 7.0, 0.001);
  EXPECT_NEAR(scan->angle(0), -kPi / 2, 1e-9);
  EXPECT_NEAR(scan->angle(180), kPi / 2, 1e-9);
  EXPECT_NEAR(scan->pointInRobot(90).x(), 7.125, 0.001);
  EXPECT_EQ(robot.echoes().size(), 181u);
  ASSERT_TRUE(robot.setLaser(false));
  EXPECT_FALSE(robot.laser()) << "what it saw once says nothing of now";
}

struct RealRobotTest : PioneerRobotTest {
  static ServerSettings settings() {
    ServerSettings real;
    real.name = "Rosie";
    real.serialNumber = "A1234";
    return real;
  }
  RealRobotTest() : PioneerRobotTest(settings()) {}
};

TEST_F(RealRobotTest, whatOnlySimulatorsCanIsRefused) {
  begin();
  EXPECT_FALSE(robot.isSimulated());
  EXPECT_THAT(robot.setLaser(true).error().text, HasSubstr("its own line"));
  EXPECT_THAT(robot.putAt({}).error().text, HasSubstr("carry it"));
  EXPECT_THAT(robot.setTruePose(true).error().text, HasSubstr("true pose"));
}

TEST_F(PioneerRobotTest, aSimulatedRobotIsPutSomewhereAndSendsItsTruePose) {
  begin();
  EXPECT_FALSE(robot.truePose());
  world.robot.sensing.truePose = {1.5, -2, radians(90.0)};
  ASSERT_TRUE(robot.setTruePose(true));
  readFor(0.3);
  ASSERT_TRUE(robot.truePose());
  EXPECT_NEAR(robot.truePose()->y, -2, 0.001);
  EXPECT_NEAR(robot.truePose()->heading, kPi / 2, 0.01);
  ASSERT_TRUE(robot.putAt({-3, 4, radians(-30.0)}));
  const auto requests = world.robot.session.takeRequests();
  ASSERT_EQ(requests.size(), 1u);
  const auto& asked = std::get<simulator_request::SetPose>(requests[0]).pose;
  EXPECT_NEAR(asked.x, -3, 1e-6);
  EXPECT_NEAR(asked.y, 4, 1e-6);
  EXPECT_NEAR(asked.heading, radians(-30.0), 1e-6);
}

TEST_F(PioneerRobotTest, anyCommandCanBeSentAndAnyPacketLookedAt) {
  begin();
  EXPECT_FALSE(robot.latest(EncoderPacket::kId));
  ASSERT_TRUE(robot.write(command(CommandId::kEncoder, 1)));
  readFor(0.3);
  EXPECT_TRUE(robot.latest(EncoderPacket::kId));
  ASSERT_TRUE(robot.write(Packet{211, {1, 2, 3}}));
  EXPECT_EQ(world.commands.back(), (Packet{211, {1, 2, 3}}));
  EXPECT_FALSE(robot.write(command(CommandId::kVel, 70'000)));
  EXPECT_FALSE(robot.write(Packet{211, Bytes(230)}));
}

TEST_F(PioneerRobotTest, noiseOnTheLineCostsNothingButItself) {
  world.noise = {'W', 'M', 'S', '2', '\r', 0xFA, 0xFB, 0xFA, 0x00};
  begin();
  readFor(1);
  EXPECT_GE(robot.linkCounts().states, 10u);
  EXPECT_GE(robot.linkCounts().skippedBytes, 100u);
}

TEST_F(PioneerRobotTest, withoutBeginNothingWorksAndItSaysWhy) {
  EXPECT_THAT(robot.read().error().text, HasSubstr("call begin() first"));
  EXPECT_THAT(robot.setSpeed(1).error().text, HasSubstr("call begin() first"));
  EXPECT_THAT(robot.resetOdometry().error().text, HasSubstr("call begin() first"));
}

TEST_F(PioneerRobotTest, aLineThatCannotBeOpenedIsTheProblem) {
  world.unplugged = true;
  EXPECT_EQ(robot.begin().error().text, "there is no cable");
  EXPECT_EQ(robot.problem(), "there is no cable");
  EXPECT_THAT(robot.read().error().text, HasSubstr("there is no cable"));
}

TEST_F(PioneerRobotTest, aRobotThatHangsUpAtOnceIsDrivenBySomebodyElse) {
  PioneerRobot second(
      [this]() -> Result<std::unique_ptr<ByteStream>> {
        auto line = std::make_unique<SimulatedLine>(world);
        world.unplugged = true;
        return line;
      },
      std::shared_ptr<const Clock>(std::shared_ptr<void>(), &world.clock));
  const auto begun = second.begin();
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().text, HasSubstr("is another program driving this robot?"));
  EXPECT_EQ(second.problem(), begun.error().text);
}

TEST_F(PioneerRobotTest, aRobotThatDoesNotAnswerIsGivenUpInTime) {
  world.silent = true;
  const Instant before = world.robot.now;
  const auto begun = robot.begin(3s);
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().text, HasSubstr("switched on"));
  EXPECT_LE(world.robot.now - before, 3100ms);
  EXPECT_FALSE(robot.isConnected());
}

TEST_F(PioneerRobotTest, aCableThatIsPulledIsNamedAndBeginConnectsAnew) {
  begin();
  robot.setMotors(true);
  readFor(1);
  world.unplugged = true;
  EXPECT_EQ(robot.read().error().text, "the cable was pulled");
  EXPECT_FALSE(robot.isConnected());
  EXPECT_EQ(robot.problem(), "the cable was pulled");
  EXPECT_THAT(robot.setSpeed(0.1).error().text, HasSubstr("the cable was pulled"));
  EXPECT_FALSE(robot.read()) << "it stays lost until begin()";

  world.unplugged = false;
  begin();
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(robot.problem(), "");
  EXPECT_FALSE(robot.motorsOn()) << "a robot that was lost stands";
  readFor(1);
}

TEST_F(PioneerRobotTest, aCableThatIsPulledIsNoticedByACommandToo) {
  begin();
  world.unplugged = true;
  EXPECT_EQ(robot.setSpeed(0.2).error().text, "the cable was pulled");
  EXPECT_FALSE(robot.isConnected());
}

TEST_F(PioneerRobotTest, silenceOfEightSecondsIsALoss) {
  begin();
  readFor(1);
  world.silent = true;
  const Instant before = world.robot.now;
  Result<bool> read = true;
  while (read && world.robot.now < before + 20s) read = robot.read();
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text, HasSubstr("8 s"));
  EXPECT_NEAR(seconds(world.robot.now - before), 8, 0.3);
}

TEST_F(PioneerRobotTest, endStopsTheRobotAndFreesItForTheNext) {
  begin();
  robot.setMotors(true);
  robot.setSpeed(0.3);
  readFor(2);
  robot.end();
  robot.end();
  EXPECT_FALSE(robot.isConnected());
  EXPECT_EQ(world.count(CommandId::kClose), 2) << "SYNC2 has the same number";
  EXPECT_EQ(world.robot.session.state(), ServerSession::State::kWaiting);
  world.advance(3s);
  EXPECT_NEAR(world.robot.sensing.leftSpeed, 0, 0.001);
  EXPECT_FALSE(robot.read());
  begin();
  EXPECT_TRUE(robot.read());
}

TEST_F(PioneerRobotTest, aRobotThatWasLeftInAConnectionIsSynchronizedAgain) {
  begin();
  world.robot.send(CommandId::kPulse);
  // Another program takes the line over, as after a crash: the robot does not know.
  PioneerRobot next([this] { return open(); },
                    std::shared_ptr<const Clock>(std::shared_ptr<void>(), &world.clock));
  const auto begun = next.begin(20s);
  EXPECT_TRUE(begun) << begun.error().text;
}

}  // namespace
}  // namespace robotlink::arcos
