// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/TeamRadio.h"

#include <gmock/gmock.h>

#include <span>

#include "app/core/team/GameEnds.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/process/Process.h"
#include "simcore/world/StateStream.h"

using namespace app;
using robotlink::Instant;
using std::chrono::milliseconds;

namespace {

Instant atMs(int ms) {
  return Instant(milliseconds(ms));
}

TeamRadio::Message saying(const std::string& state) {
  auto message = std::make_shared<robotcontrol::TeamMessage>();
  message->set_state(state);
  return message;
}

/// Two red robots and a blue one.
class Radio : public testing::Test {
 protected:
  Radio() {
    radio_.setStations({{"red1", "red", {0, 0}}, {"red2", "red", {2, 0}}, {"blue1", "blue", {1, 0}}});
  }
  /// "sender: state" of all that a robot knows, if there is something new.
  std::vector<std::string> heard(const std::string& robot, int ms) {
    std::vector<std::string> all;
    if (const auto messages = radio_.receive(robot, atMs(ms))) {
      for (const auto& message : messages->messages())
        all.push_back(message.sender() + ": " + message.state());
    }
    return all;
  }
  TeamRadio radio_{7};
};

/// A process with ends for a test.
class OneProcess final : public robotlink::Process {
 public:
  using Process::Process;
  std::function<void()> frame;
  void execute() override { frame(); }
};

}  // namespace

TEST_F(Radio, messagesArriveAtTheOthersOfTheTeamOnly) {
  radio_.send("red1", saying("ball"), atMs(0));
  EXPECT_THAT(heard("red2", 0), testing::ElementsAre("red1: ball"));
  EXPECT_THAT(heard("red2", 8), testing::IsEmpty()) << "nothing new";
  EXPECT_THAT(heard("red1", 8), testing::IsEmpty());
  EXPECT_THAT(heard("blue1", 8), testing::IsEmpty());
  radio_.send("nobody", saying("ball"), atMs(8));
  EXPECT_EQ(radio_.sent(), 1U);
}

TEST_F(Radio, theyTakeTheirTimeAndEndAtTheRange) {
  radio_.setSettings({.range = 0, .delay = 0.1, .loss = 0});
  radio_.send("red1", saying("early"), atMs(0));
  EXPECT_THAT(heard("red2", 96), testing::IsEmpty());
  EXPECT_THAT(heard("red2", 104), testing::ElementsAre("red1: early"));
  radio_.setSettings({.range = 1.5, .delay = 0, .loss = 0});
  radio_.send("red1", saying("far"), atMs(200));
  EXPECT_THAT(heard("red2", 300), testing::IsEmpty());
  EXPECT_EQ(radio_.lost(), 1U);
}

TEST_F(Radio, whatIsOvertakenIsOld) {
  radio_.setSettings({.range = 0, .delay = 1, .loss = 0});
  radio_.send("red1", saying("slow"), atMs(0));
  radio_.setSettings({.range = 0, .delay = 0, .loss = 0});
  radio_.send("red1", saying("fast"), atMs(10));
  EXPECT_THAT(heard("red2", 10), testing::ElementsAre("red1: fast"));
  EXPECT_THAT(heard("red2", 2000), testing::IsEmpty());
}

TEST_F(Radio, asManyAreLostAsWasAskedForAndAlwaysTheSame) {
  const auto arrived = [&](std::uint64_t seed) {
    radio_.restart(seed);
    radio_.setSettings({.range = 0, .delay = 0, .loss = 0.3});
    std::vector<bool> result;
    for (int i = 0; i < 2000; ++i) {
      radio_.send("red1", saying("x"), atMs(i));
      result.push_back(!heard("red2", i).empty());
    }
    return result;
  };
  const auto first = arrived(7);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(first, true)) / 2000, 0.7, 0.03);
  EXPECT_EQ(arrived(7), first);
  EXPECT_NE(arrived(8), first);
  EXPECT_EQ(radio_.sent(), 2000U);
}

TEST_F(Radio, aSnapshotKeepsWhatIsOnTheWayAndWhatIsLost) {
  radio_.setSettings({.range = 0, .delay = 0.5, .loss = 0.3});
  for (int i = 0; i < 20; ++i) radio_.send("red1", saying(std::to_string(i)), atMs(20 * i));
  (void)heard("red2", 500);
  std::vector<std::uint8_t> bytes;
  simcore::StateStream writing(bytes);
  radio_.transfer(writing, atMs(500));
  const auto goesOn = [this](int now) {
    std::vector<std::string> all;
    for (int i = 0; i < 100; ++i) {
      radio_.send("red1", saying("later " + std::to_string(i)), atMs(now + 20 * i));
      for (const std::string& text : heard("red2", now + 20 * i)) all.push_back(text);
    }
    return std::pair(all, radio_.lost());
  };
  const auto then = goesOn(500);
  EXPECT_FALSE(then.first.empty());
  simcore::StateStream reading(bytes, simcore::StateStream::Trust::kForeign);
  radio_.transfer(reading, atMs(9000));
  EXPECT_TRUE(reading.complete());
  EXPECT_EQ(goesOn(9000), then) << "the same is lost, and the same arrives after the same time";
}

TEST_F(Radio, aSnapshotThatIsCutIsNotedAsSuch) {
  radio_.setSettings({.range = 0, .delay = 0.5, .loss = 0});
  radio_.send("red1", saying("ball"), atMs(0));
  std::vector<std::uint8_t> bytes;
  simcore::StateStream writing(bytes);
  radio_.transfer(writing, atMs(0));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    simcore::StateStream reading(std::span<const std::uint8_t>(bytes).first(size),
                                 simcore::StateStream::Trust::kForeign);
    TeamRadio read;
    read.transfer(reading, atMs(0));
    EXPECT_FALSE(reading.complete()) << size;
  }
}

TEST(GameEnds, carryWhatTheRefereeAndTheTeamSay) {
  robotlink::ManualClock clock;
  OneProcess platform("platform", clock), program("program", clock);
  const auto mail = std::make_shared<GameMail>();
  GameEnds ends(platform, mail);
  robotlink::Receiver<robotcontrol::GameState> state(program, "game/state", robotlink::Blocking::kNo);
  robotlink::Receiver<robotcontrol::TeamMessages> received(program, "team/messages",
                                                           robotlink::Blocking::kNo);
  robotlink::Sender<robotcontrol::TeamMessage> sent(program, "team/message", robotlink::Blocking::kNo);
  connectUnchecked(*platform.senders()[0], state);
  connectUnchecked(*platform.senders()[1], received);
  connectUnchecked(sent, *platform.receivers()[0]);
  platform.frame = [&] { ends.exchange(); };
  program.frame = [&] { sent.send(saying("hello")); };
  const auto frame = [](OneProcess& process) {
    process.tryBeginFrame();
    process.runFrame();
  };
  frame(program);
  auto said = std::make_shared<robotcontrol::GameState>();
  said->set_half(2);
  mail->state = said;
  frame(platform);
  ASSERT_TRUE(mail->sent);
  EXPECT_EQ(mail->sent->state(), "hello");
  mail->received = std::make_shared<robotcontrol::TeamMessages>();
  frame(platform);
  EXPECT_FALSE(mail->received) << "it was taken";
  frame(program);
  ASSERT_NE(state.get(), nullptr);
  EXPECT_EQ(state.get()->half(), 2U);
  EXPECT_NE(received.get(), nullptr);
  EXPECT_EQ(platform.senders()[0]->sent(), 1U) << "what has not changed is not sent again";
}
