// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionPlayer.h"

#include <gtest/gtest.h>

#include "robotlink/base/Geometry.h"
#include "robotlink/motions/MotionReader.h"

namespace robotlink {
namespace {

using std::chrono::milliseconds;

/// A player for a robot of the joints a and b; `motions` are texts beside an extern.mof that lists nod and
/// shake.
class PlayerFixture {
 public:
  explicit PlayerFixture(const std::vector<std::string>& motions) : player_(compiled(motions)) {
    player_.start(std::vector<double>{0, 0});
  }
  MotionPlayer& operator*() { return player_; }
  MotionPlayer* operator->() { return &player_; }
  double degreesOf(std::size_t joint) const { return degrees(player_.angles()[joint]); }
  void play(int frames) {
    for (int i = 0; i < frames; ++i) player_.advance(milliseconds(8));
  }

 private:
  static std::shared_ptr<const MotionNet> compiled(const std::vector<std::string>& motions) {
    std::string table = "motion_id = extern\nlabel start\n";
    std::vector<MotionFile> files;
    for (const std::string& text : motions) {
      files.push_back(readMotion(text, "x.mof").value());
      table += "transition " + files.back().name + " " + files.back().name + " start\n";
    }
    files.push_back(readMotion(table + "transition extern extern start\n", "extern.mof").value());
    auto net = compileMotions(files, {"a", "b"});
    if (!net) ADD_FAILURE() << describe(net.error());
    return *net;
  }

  MotionPlayer player_;
};

const std::string kEnd = "transition allMotions extern start\n";

TEST(MotionPlayerTest, anglesGoLinearlyToAKeyFrame) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 1 80\n" + kEnd});
  ASSERT_TRUE(player->request("nod"));
  for (int i = 1; i <= 10; ++i) {
    player.play(1);
    EXPECT_NEAR(player.degreesOf(0), 8 * i, 1e-9);
    EXPECT_EQ(player.degreesOf(1), 0);
  }
  EXPECT_TRUE(player->moves(0));
  EXPECT_FALSE(player->moves(1));
}

TEST(MotionPlayerTest, withoutInterpolationAnglesJumpAndAreHeld) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 0 16\n-80 * 0 16\n" + kEnd});
  player->request("nod");
  player.play(1);
  EXPECT_NEAR(player.degreesOf(0), 80, 1e-9);
  player.play(2);
  EXPECT_NEAR(player.degreesOf(0), -80, 1e-9);
}

TEST(MotionPlayerTest, softInterpolationStartsAndEndsSlowly) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 3 80\n" + kEnd});
  player->request("nod");
  player.play(1);
  EXPECT_LT(player.degreesOf(0), 3);
  player.play(4);
  EXPECT_NEAR(player.degreesOf(0), 40, 1e-9);
}

TEST(MotionPlayerTest, timeThatIsLeftGoesToTheNextKeyFrame) {
  PlayerFixture player({"motion_id = nod\nlabel start\n10 * 1 10\n20 * 1 10\n" + kEnd});
  player->request("nod");
  player.play(2);
  EXPECT_NEAR(player.degreesOf(0), 16, 1e-9);
}

TEST(MotionPlayerTest, aClearedRequestRunsToItsEndAndKeepsTheLastAngles) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 1 80\n" + kEnd});
  player->request("nod");
  EXPECT_FALSE(player->finished());
  player.play(1);
  EXPECT_EQ(player->motion(), "nod");
  player->clear();
  player.play(8);
  EXPECT_FALSE(player->finished());
  player.play(2);
  EXPECT_TRUE(player->finished());
  EXPECT_EQ(player->motion(), "");
  player.play(5);
  EXPECT_NEAR(player.degreesOf(0), 80, 1e-9);
}

TEST(MotionPlayerTest, aMotionIsRepeatedWhileItIsWanted) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 0 8\n0 * 0 8\n" + kEnd});
  player->request("nod");
  for (int i = 0; i < 3; ++i) {
    player.play(1);
    EXPECT_NEAR(player.degreesOf(0), 80, 1e-9);
    player.play(1);
    EXPECT_NEAR(player.degreesOf(0), 0, 1e-9);
  }
  EXPECT_FALSE(player->finished());
}

TEST(MotionPlayerTest, aMotionThatIsWantedOnceEndsAndCanBeWantedAnew) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 0 8\n0 * 0 8\n" + kEnd});
  for (int round = 0; round < 2; ++round) {
    int frames = 0;
    player->request("nod", MotionPlayer::Repeat::kOnce);
    while (!player->finished() && ++frames < 10) {
      player->request("nod", MotionPlayer::Repeat::kOnce);
      player.play(1);
    }
    EXPECT_EQ(frames, 3);
  }
}

TEST(MotionPlayerTest, aMotionThatHoldsGoesOnWhileItIsWantedOnce) {
  PlayerFixture player(
      {"motion_id = nod\nlabel start\nlabel hold\n80 * 0 8\ntransition nod nod hold\n0 * 0 8\n" + kEnd});
  for (int i = 0; i < 20; ++i) {
    player->request("nod", MotionPlayer::Repeat::kOnce);
    player.play(1);
  }
  EXPECT_FALSE(player->finished());
  player->clear();
  player.play(5);
  EXPECT_TRUE(player->finished());
  EXPECT_NEAR(player.degreesOf(0), 0, 1e-9);
}

TEST(MotionPlayerTest, aMotionIsLeftOnlyWhereATransitionAllowsIt) {
  PlayerFixture player(
      {"motion_id = nod\nlabel start\n10 * 1 80\ntransition shake shake start\n20 * 1 80\n" + kEnd,
       "motion_id = shake\nlabel start\n* 50 0 8\n" + kEnd});
  player->request("nod");
  player.play(5);
  player->request("shake");
  player.play(5);
  EXPECT_EQ(player.degreesOf(1), 0);
  player.play(1);
  EXPECT_NEAR(player.degreesOf(0), 10, 1e-9);
  EXPECT_NEAR(player.degreesOf(1), 50, 1e-9);
}

TEST(MotionPlayerTest, hardnessChangesWhileTheMotionGoesOn) {
  PlayerFixture player({"motion_id = nod\nlabel start\nhardness 0 * 80\n80 * 1 160\n- * 1 8\n" + kEnd});
  player->request("nod");
  player.play(1);
  EXPECT_NEAR(player.degreesOf(0), 4, 1e-9);
  player.play(5);
  EXPECT_NEAR(player->shares()[0], 0.5, 1e-9);
  EXPECT_EQ(player->shares()[1], 1);
  player.play(16);
  EXPECT_EQ(player->shares()[0], 0);
  player->start(std::vector<double>{0, 0});
  EXPECT_EQ(player->shares()[0], 1);
}

TEST(MotionPlayerTest, unknownMotionsAreRefused) {
  PlayerFixture player({"motion_id = nod\nlabel start\n80 * 1 80\n" + kEnd});
  EXPECT_FALSE(player->request("wink"));
  EXPECT_TRUE(player->finished());
}

TEST(MotionPlayerTest, aRingOfTransitionsDoesNotHangTheRobot) {
  PlayerFixture player({"motion_id = nod\nlabel start\ntransition allMotions shake start\n",
                        "motion_id = shake\nlabel start\ntransition allMotions nod start\n"});
  player->request("nod");
  player.play(3);
  EXPECT_EQ(player.degreesOf(0), 0);
}

}  // namespace
}  // namespace robotlink
