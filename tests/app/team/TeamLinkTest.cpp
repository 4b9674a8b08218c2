// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/team/TeamLink.h"

#include <gmock/gmock.h>

#include <limits>

#include "app/core/team/TeamDatagram.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/process/Platform.h"
#include "tests/Eventually.h"

using namespace app;
using robotcontrol::TeamMessage;

namespace {

TeamMessage messageOf(const std::string& sender, const std::string& team = "red") {
  TeamMessage message;
  message.set_sender(sender);
  message.set_team(team);
  message.set_state("going");
  return message;
}

std::vector<std::uint8_t> datagramOf(const TeamMessage& message) {
  return teamDatagram(message).value();
}

/// Refused for a reason that contains this.
void expectRefused(const std::vector<std::uint8_t>& datagram, const std::string& reason) {
  const auto message = teamMessageIn(datagram);
  ASSERT_FALSE(message) << reason;
  EXPECT_THAT(message.error().text, testing::HasSubstr(reason));
}

/// A platform that does nothing, and a program that sends one message in each frame.
struct Robot {
  struct Body final : robotlink::Platform {
    using Platform::Platform;
    void actuate() override {}
    void engageStop(bool) override {}
    void execute() override {}
  };
  struct Program final : robotlink::Process {
    using Process::Process;
    robotlink::Sender<TeamMessage> sent{*this, "team/message", robotlink::Blocking::kNo};
    robotlink::Receiver<robotcontrol::TeamMessages> received{*this, "team/messages",
                                                             robotlink::Blocking::kNo};
    void execute() override { sent.send(std::make_shared<const TeamMessage>(messageOf("", ""))); }
  };

  explicit Robot(const TeamLinkOptions& options, const std::string& name) {
    auto opened = TeamLink::open(options, name, "red");
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().text);
    link = std::move(*opened);
    EXPECT_TRUE(link->attach(body));
    connectUnchecked(*body.senders()[1], program.received);
    connectUnchecked(program.sent, *body.receivers()[0]);
  }
  void step() {
    for (robotlink::Process* process :
         {static_cast<robotlink::Process*>(&program), static_cast<robotlink::Process*>(&body)}) {
      process->tryBeginFrame();
      process->runFrame();
    }
    link->step(clock.now());
  }
  std::vector<std::string> heard() const {
    std::vector<std::string> senders;
    if (program.received.get() != nullptr)
      for (const auto& message : program.received.get()->messages()) senders.push_back(message.sender());
    return senders;
  }

  robotlink::ManualClock clock;
  std::unique_ptr<TeamLink> link;
  Body body{"platform", clock};
  Program program{"program", clock};
};

std::string addressAt(std::uint16_t port) {
  return "127.0.0.1:" + std::to_string(port);
}

}  // namespace

TEST(TeamDatagram, aMessageComesBackAsItWas) {
  TeamMessage message = messageOf("red1");
  message.mutable_pose_in_field()->set_x(1.25);
  const auto read = teamMessageIn(datagramOf(message));
  ASSERT_TRUE(read);
  EXPECT_EQ((*read)->SerializeAsString(), message.SerializeAsString());
}

TEST(TeamDatagram, whatIsNoneIsRefusedWithTheReason) {
  const auto good = datagramOf(messageOf("red1"));
  auto other = good;
  other[0] ^= 1U;
  expectRefused(other, "begins with other bytes");
  other = good;
  other[4] = 2;
  expectRefused(other, "version 2");
  other = good;
  other.push_back(0);
  expectRefused(other, "length");
  other = good;
  other.back() ^= 1U;
  expectRefused(other, "damaged");
  expectRefused({}, "begins with other bytes");
  expectRefused(datagramOf(messageOf("")), "does not name its sender");
  TeamMessage wild = messageOf("red1");
  wild.set_ball_deviation(std::numeric_limits<double>::quiet_NaN());
  expectRefused(datagramOf(wild), "not numbers");
  wild.set_state(std::string(2000, 'x'));
  EXPECT_FALSE(teamDatagram(wild)) << "too long";
}

TEST(TeamLink, robotsOfATeamHearEachOther) {
  Robot first({.port = 0}, "red1");
  Robot second({.port = 0, .peers = {addressAt(first.link->port())}}, "red2");
  Robot stranger({.port = 0, .peers = {addressAt(first.link->port())}, .team = "blue"}, "blue1");
  EXPECT_TRUE(eventually([&] {
    second.step();
    stranger.step();
    first.step();
    return !first.heard().empty() && first.link->counts().leftOut > 0;
  }));
  EXPECT_THAT(first.heard(), testing::ElementsAre("red2")) << "those of other teams are left out";
  EXPECT_TRUE(second.heard().empty());
}

TEST(TeamLink, saysWhyItCannotBeOpened) {
  const auto open = [](const TeamLinkOptions& options) { return TeamLink::open(options, "red1", "red"); };
  EXPECT_THAT(open({.port = 0, .peers = {"nowhere"}}).error().text, testing::HasSubstr("HOST:PORT"));
  const auto first = open({.port = 0});
  ASSERT_TRUE(first);
  const auto second = open({.port = (*first)->port()});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().id, "team.socket");
}

TEST(TeamLink, refusesAPlatformThatCarriesMessagesItself) {
  Robot robot({.port = 0}, "red1");
  const auto other = TeamLink::open({.port = 0}, "red1", "red");
  ASSERT_TRUE(other);
  EXPECT_EQ((*other)->attach(robot.body).error().id, "team.platform");
}
