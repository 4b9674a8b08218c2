// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/PackageBoard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/debugging/DebugContext.h"
#include "tests/robotlink/debugging/ToyRobot.h"

using namespace robotlink;
using namespace robotlink::test;
using robotcontrol::KeyMode;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

class PackageBoardTest : public ::testing::Test {
 protected:
  PackageBoardTest() {
    board_.entry("ball").shown = true;
    board_.entry("pose").shown = true;
    board_.entry("secret");
  }
  /// Senders of the board are closed before it ends.
  ~PackageBoardTest() override { process_.stop(); }
  static KeyMode mode(KeyMode::Kind kind, unsigned n = 0) {
    KeyMode mode;
    mode.set_kind(kind);
    mode.set_n(n);
    return mode;
  }
  /// Sends each package once; what is published of them, those for the recorder alone in brackets.
  std::vector<std::string> published() {
    debug_.beginFrame(clock_.now(), ++frame_);
    for (const char* name : {"ball", "pose", "secret"})
      board_.send(board_.entry(name), std::make_shared<robotcontrol::BallModel>());
    debug_.endFrame();
    std::vector<std::string> paths;
    const auto queue = debug_.takeQueue();
    for (const SharedDebugMessage& message : queue->messages) {
      if (message.as<robotcontrol::FrameInfo>() == nullptr)
        paths.push_back(message.onlyRecorded ? "(" + message.path + ")" : message.path);
    }
    return paths;
  }

  ManualClock clock_;
  ToyPlatform process_{"toy", clock_};
  DebugContext debug_{"toy", clock_, {}};
  PackageBoard board_{process_, debug_};
  std::uint64_t frame_ = 0;
};

TEST_F(PackageBoardTest, onlyPackagesThatItPublishesCanBeAskedFor) {
  EXPECT_TRUE(board_.show("ball", mode(KeyMode::ALWAYS)));
  EXPECT_FALSE(board_.show("secret", mode(KeyMode::ALWAYS)));
  EXPECT_FALSE(board_.show("none", mode(KeyMode::ALWAYS)));
  EXPECT_THAT(published(), ElementsAre("ball"));
  EXPECT_TRUE(board_.show("ball", mode(KeyMode::OFF)));
  EXPECT_THAT(published(), IsEmpty());
  ASSERT_EQ(board_.shown().size(), 2U);
  EXPECT_EQ(board_.shown()[1]->name, "pose");
}

TEST_F(PackageBoardTest, aModeThatRunsOutIsNoticedOnce) {
  board_.show("pose", mode(KeyMode::N_TIMES, 2));
  EXPECT_THAT(published(), ElementsAre("pose"));
  EXPECT_FALSE(board_.takeModeChange());
  EXPECT_THAT(published(), ElementsAre("pose"));
  EXPECT_TRUE(board_.takeModeChange());
  EXPECT_FALSE(board_.takeModeChange());
  EXPECT_THAT(published(), IsEmpty());
}

TEST_F(PackageBoardTest, theRecorderGetsItsPackagesWhateverTheirMode) {
  board_.record({"ball", "secret"});
  EXPECT_THAT(published(), ElementsAre("(ball)"));
  board_.show("ball", mode(KeyMode::ALWAYS));
  EXPECT_THAT(published(), ElementsAre("ball"));
  board_.record({"pose"});
  EXPECT_THAT(published(), ElementsAre("ball", "(pose)"));
}

TEST_F(PackageBoardTest, aValueTakesThePlaceOfPackagesUntilItIsReleased) {
  PackageBoard::Entry& pose = board_.entry("pose");
  board_.addSender("pose", Blocking::kNo);
  pose.settable = true;
  published();
  const auto held = std::make_shared<robotcontrol::BallModel>();
  held->set_known(true);
  board_.hold("pose", held);
  EXPECT_TRUE(pose.sender->held());
  published();
  EXPECT_TRUE(static_cast<const robotcontrol::BallModel&>(*pose.value).known());
  published();
  EXPECT_TRUE(static_cast<const robotcontrol::BallModel&>(*pose.value).known());
  const auto arrivals = pose.arrivals;
  board_.endFrame();
  EXPECT_EQ(pose.arrivals, arrivals) << "the task has sent in this frame";
  board_.release("pose");
  EXPECT_FALSE(pose.sender->held());
  board_.endFrame();
  EXPECT_FALSE(static_cast<const robotcontrol::BallModel&>(*pose.value).known()) << "though no task sends";
}

TEST_F(PackageBoardTest, aValueIsSentOnceInPlaceOfTheNextPackageOrAtTheFramesEnd) {
  PackageBoard::Entry& ball = board_.entry("ball");
  board_.addSender("ball", Blocking::kNo);
  ball.settable = true;
  const auto value = std::make_shared<robotcontrol::BallModel>();
  value->set_known(true);
  board_.setOnce("ball", value);
  published();
  EXPECT_TRUE(static_cast<const robotcontrol::BallModel&>(*ball.value).known());
  published();
  EXPECT_FALSE(static_cast<const robotcontrol::BallModel&>(*ball.value).known());
  board_.setOnce("ball", value);
  board_.endFrame();
  EXPECT_TRUE(static_cast<const robotcontrol::BallModel&>(*ball.value).known());
  EXPECT_FALSE(ball.sender->held());
}

TEST_F(PackageBoardTest, onlyPackagesThatBelongHereCanBeSet) {
  board_.setOnce("ball", std::make_shared<robotcontrol::BallModel>());
  board_.hold("none", std::make_shared<robotcontrol::BallModel>());
  EXPECT_FALSE(board_.isSettable("ball"));
  board_.endFrame();
  EXPECT_EQ(board_.entry("ball").arrivals, 0U);
}

TEST_F(PackageBoardTest, everyPackageCountsAsAnArrival) {
  PackageBoard::Entry& ball = board_.entry("ball");
  published();
  const PackagePtr first = ball.value;
  published();
  EXPECT_EQ(ball.arrivals, 2U);
  EXPECT_NE(ball.value, first);
  EXPECT_EQ(&board_.entry("ball"), &ball);
}

}  // namespace
