// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerDriver.h"

#include <gtest/gtest.h>

#include "foxglove/Ranging.pb.h"
#include "robotlink/arcos/server/ServerSession.h"
#include "robotlink/base/Resources.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/process/InProcessLink.h"

using namespace app;
using robotlink::Blocking;
using robotlink::Instant;
using std::chrono::milliseconds;
namespace arcos = robotlink::arcos;

namespace {

/// A process of which only the ends of its links matter.
class Ends final : public robotlink::Process {
 public:
  using Process::Process;

 protected:
  void execute() override {}
};

class FixedRanges final : public arcos::RangeFinders {
 public:
  double sonar(int number) override { return 1 + 0.1 * number; }
  std::span<const double> laser() override { return scan_; }

 private:
  std::vector<double> scan_ = std::vector<double>(181, 2.5);
};

/// The driver and a microcontroller whose wheels turn as they are told, without a line between them.
class PioneerDriverTest : public testing::Test {
 protected:
  PioneerDriverTest() {
    robotlink::connect(*findSender<robotcontrol::DriveState>("drive/state"), state_);
    robotlink::connect(*findSender<robotcontrol::SonarReadings>("range/sonar"), sonar_);
    robotlink::connect(*findSender<foxglove::LaserScan>("range/laser"), laser_);
    robotlink::connect(*findSender<robotcontrol::LinkStatus>("link/status"), status_);
    for (robotlink::AnyReceiver* receiver : platform_.receivers())
      robotlink::connectUnchecked(request_, *receiver);
  }

  template <typename T>
  robotlink::Sender<T>* findSender(const std::string& package) {
    for (robotlink::AnySender* sender : platform_.senders()) {
      if (sender->package() == package) return static_cast<robotlink::Sender<T>*>(sender);
    }
    return nullptr;
  }

  void step() {
    clock_.advance(milliseconds(10));
    const Instant now = clock_.now();
    const arcos::WheelCommand wheels = server_.step(sensing_, ranges_, now);
    sensing_.leftSpeed = wheels.motorsOn ? wheels.left : 0;
    sensing_.rightSpeed = wheels.motorsOn ? wheels.right : 0;
    sensing_.leftTravel += 0.01 * sensing_.leftSpeed;
    sensing_.rightTravel += 0.01 * sensing_.rightSpeed;
    for (const auto& packet : server_.takeOutgoing()) driver_.take(packet, now);
    if (driver_.waitsForLine()) driver_.lineOpened(now);
    platform_.tryBeginFrame();
    driver_.actuate(stop_, now);
    for (const auto& packet : driver_.takeOutgoing(now)) {
      server_.take(packet, now);
      sent_.push_back(packet);
    }
    driver_.sendPackages(now);
    platform_.runFrame();
    program_.tryBeginFrame();
    program_.runFrame();
  }
  void play(double seconds) {
    for (int i = 0; i < static_cast<int>(100 * seconds); ++i) step();
  }
  void playAsking(double seconds, double speed, double rotation) {
    for (int i = 0; i < static_cast<int>(100 * seconds); ++i) {
      if (i % 10 == 0) ask(speed, rotation);
      step();
    }
  }
  void ask(double speed, double rotation) {
    auto request = std::make_shared<robotcontrol::DriveRequest>();
    request->mutable_velocity()->set_x(speed);
    request->mutable_velocity()->set_rotation(rotation);
    request_.send(std::move(request));
  }
  static arcos::ServerSettings settings() {
    arcos::ServerSettings settings;
    settings.lowVoltage = 11.8;
    settings.shutdownVoltage = 11.2;
    return settings;
  }
  robotcontrol::ControlDrive motors(bool on) const {
    robotcontrol::ControlDrive details;
    details.set_motors(on);
    return details;
  }

  robotlink::ManualClock clock_;
  robotlink::RobotDescription description_ =
      *robotlink::readRobotDescription(robotlink::resource("robots/p3at.yaml"));
  Ends platform_{"platform", clock_}, program_{"program", clock_};
  PioneerDriver driver_{platform_, "p3at1", description_, {.address = "test"}};
  arcos::ServerSession server_{settings()};
  arcos::RobotSensing sensing_;
  FixedRanges ranges_;
  std::vector<arcos::Packet> sent_;
  bool stop_ = false;
  robotlink::Receiver<robotcontrol::DriveState> state_{program_, "drive/state", Blocking::kNo};
  robotlink::Receiver<robotcontrol::SonarReadings> sonar_{program_, "range/sonar", Blocking::kNo};
  robotlink::Receiver<foxglove::LaserScan> laser_{program_, "range/laser", Blocking::kNo};
  robotlink::Receiver<robotcontrol::LinkStatus> status_{program_, "link/status", Blocking::kNo};
  robotlink::Sender<robotcontrol::DriveRequest> request_{program_, "drive/request", Blocking::kNo};
};

}  // namespace

TEST_F(PioneerDriverTest, itConnectsAndPublishesWhatTheRobotSenses) {
  play(3);
  ASSERT_NE(state_.get(), nullptr);
  EXPECT_FALSE(state_.get()->motors_on());  // a real robot waits for a person
  EXPECT_EQ(state_.get()->battery_low(), 11.8) << "as it says in its configuration";
  EXPECT_EQ(state_.get()->battery_empty(), 11.2);
  ASSERT_NE(sonar_.get(), nullptr);
  ASSERT_GT(sonar_.get()->readings_size(), 0);
  const auto& reading = sonar_.get()->readings(0);
  EXPECT_NEAR(reading.range(), 1 + 0.1 * reading.number(), 0.002);
  ASSERT_NE(laser_.get(), nullptr);
  EXPECT_EQ(laser_.get()->ranges_size(), 181);
  EXPECT_NEAR(laser_.get()->ranges(90), 2.5, 1e-9);
  ASSERT_NE(status_.get(), nullptr);
  EXPECT_EQ(status_.get()->state(), robotcontrol::LinkStatus::CONNECTED);
  EXPECT_EQ(status_.get()->robot_subclass(), "p3at-sh");
}

TEST_F(PioneerDriverTest, aGripperIsPublishedIfTheRobotHasOne) {
  robotlink::Receiver<robotcontrol::GripperState> gripper{program_, "body/gripper", robotlink::Blocking::kNo};
  robotlink::connect(*findSender<robotcontrol::GripperState>("body/gripper"), gripper);
  play(2);
  EXPECT_EQ(gripper.get(), nullptr);
  arcos::Configuration configuration;
  configuration.gripper = 1;
  driver_.take(arcos::toPacket(configuration), clock_.now());
  arcos::StandardInformation information;
  information.gripState = std::uint8_t{0b0010'0010};
  driver_.take(arcos::toPacket(information), clock_.now());
  driver_.sendPackages(clock_.now());
  platform_.runFrame();
  program_.tryBeginFrame();
  ASSERT_NE(gripper.get(), nullptr);
  EXPECT_TRUE(gripper.get()->closed());
  EXPECT_TRUE(gripper.get()->lift_down());
  EXPECT_FALSE(gripper.get()->moving());
}

TEST_F(PioneerDriverTest, itDrivesAsTheProgramWantsOnceTheMotorsAreOn) {
  play(2);
  playAsking(1, 0.3, 0);
  EXPECT_EQ(sensing_.leftTravel, 0);
  ASSERT_TRUE(driver_.control(motors(true), clock_.now()));
  playAsking(4, 0.3, 0);
  EXPECT_NEAR(state_.get()->velocity().x(), 0.3, 0.002);
  EXPECT_NEAR(state_.get()->odometry().x(), sensing_.leftTravel, 0.05);
  playAsking(4, 0, -0.5);
  EXPECT_NEAR(state_.get()->velocity().rotation(), -0.5, 0.02);
}

TEST_F(PioneerDriverTest, aProgramThatFallsSilentLetsTheRobotStand) {
  play(2);
  ASSERT_TRUE(driver_.control(motors(true), clock_.now()));
  playAsking(2, 0.3, 0);
  EXPECT_GT(sensing_.leftSpeed, 0.2);
  play(3);
  EXPECT_EQ(sensing_.leftSpeed, 0);
  EXPECT_TRUE(state_.get()->motors_on());
  playAsking(2, 0.3, 0);
  EXPECT_GT(sensing_.leftSpeed, 0.2);
}

TEST_F(PioneerDriverTest, stopTakesTheMotorsOffUntilItIsReleased) {
  play(2);
  ASSERT_TRUE(driver_.control(motors(true), clock_.now()));
  playAsking(2, 0.3, 0);
  stop_ = true;
  playAsking(0.3, 0.3, 0);
  EXPECT_EQ(sensing_.leftSpeed, 0);
  EXPECT_FALSE(state_.get()->motors_on());
  EXPECT_FALSE(driver_.control(motors(true), clock_.now()));
  stop_ = false;
  playAsking(2, 0.3, 0);
  EXPECT_GT(sensing_.leftSpeed, 0.2);
}

TEST_F(PioneerDriverTest, afterItWasHeldOnlyNewRequestsCount) {
  play(2);
  ASSERT_TRUE(driver_.control(motors(true), clock_.now()));
  playAsking(2, 0.3, 0);
  stop_ = true;
  play(0.3);
  EXPECT_EQ(sensing_.leftSpeed, 0);
  // A program that takes the place of another one has not requested anything yet.
  stop_ = false;
  play(0.5);
  EXPECT_TRUE(state_.get()->motors_on());
  EXPECT_EQ(sensing_.leftSpeed, 0);
  playAsking(2, 0.3, 0);
  EXPECT_GT(sensing_.leftSpeed, 0.2);
}

TEST_F(PioneerDriverTest, wishesThatAreNoNumbersOrTooLargeAreLimited) {
  play(2);
  ASSERT_TRUE(driver_.control(motors(true), clock_.now()));
  playAsking(4, 50, std::nan(""));
  EXPECT_NEAR(sensing_.leftSpeed, description_.drive->maximumSpeed, 0.01);
  EXPECT_NEAR(sensing_.rightSpeed, sensing_.leftSpeed, 1e-9);
}

TEST_F(PioneerDriverTest, packetsThatAPersonSendsMustBeWhole) {
  play(2);
  robotcontrol::ControlDrive details;
  const auto pulse = arcos::encode(arcos::toPacket(arcos::command(arcos::CommandId::kPulse)));
  details.add_packets(std::string(pulse.begin(), pulse.end()));
  EXPECT_TRUE(driver_.control(details, clock_.now()));
  details.add_packets("hello");
  const auto refused = driver_.control(details, clock_.now());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "drive.packet");
}

TEST_F(PioneerDriverTest, aGripperThatTheRobotDoesNotHaveIsNotMoved) {
  play(2);
  const auto open = arcos::encode(arcos::toPacket(arcos::command(arcos::CommandId::kGripper, 1)));
  robotcontrol::ControlDrive details;
  details.add_packets(std::string(open.begin(), open.end()));
  arcos::Configuration configuration;
  driver_.take(arcos::toPacket(configuration), clock_.now());
  const auto refused = driver_.control(details, clock_.now());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, "drive.no-gripper");
  configuration.gripper = 2;
  driver_.take(arcos::toPacket(configuration), clock_.now());
  EXPECT_TRUE(driver_.control(details, clock_.now()));
}

TEST_F(PioneerDriverTest, whileSomebodyElseDrivesItListensOnly) {
  play(2);
  driver_.setOtherClient("127.0.0.1:4711", clock_.now());
  sent_.clear();
  for (int i = 0; i < 50; ++i) {
    clock_.advance(milliseconds(100));
    arcos::StandardInformation information;
    information.xMm = static_cast<std::int16_t>(10 * i);
    driver_.overhear(arcos::toPacket(information), true, clock_.now());
    platform_.tryBeginFrame();
    driver_.actuate(false, clock_.now());
    for (const auto& packet : driver_.takeOutgoing(clock_.now())) sent_.push_back(packet);
    driver_.sendPackages(clock_.now());
    platform_.runFrame();
    program_.tryBeginFrame();
    program_.runFrame();
  }
  EXPECT_TRUE(sent_.empty());
  EXPECT_NEAR(state_.get()->odometry().x(), 0.48, 1e-9);  // from the first packet that it heard on
  EXPECT_EQ(status_.get()->client(), "127.0.0.1:4711");
  EXPECT_FALSE(driver_.control(motors(true), clock_.now()));
  driver_.setOtherClient("", clock_.now());
  server_.clientGone(clock_.now());
  play(3);
  EXPECT_EQ(status_.get()->state(), robotcontrol::LinkStatus::CONNECTED);
}
