// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/GameCommands.h"

#include <gmock/gmock.h>

#include "robotcontrol/Game.pb.h"
#include "tests/app/open/AskedWorkbench.h"

namespace app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class GameCommandsTest : public testing::Test {
 protected:
  test::AskedWorkbench desk_;
};

TEST_F(GameCommandsTest, thePhasesOfAGameAreAskedForByTheirNames) {
  for (const char* phase : {"READY", "SET", "PLAY", "FINISH", "RESTART"}) {
    std::string name = phase;
    for (char& letter : name) letter = static_cast<char>(std::tolower(letter));
    EXPECT_EQ(desk_.run("game." + name), "control_game { action: " + std::string(phase) + " }");
  }
}

TEST_F(GameCommandsTest, robotsArePenalizedForAReasonOrTheUsualOne) {
  EXPECT_EQ(desk_.run("game.penalize red1"), "control_game { action: PENALIZE robot: \"red1\" }");
  EXPECT_EQ(desk_.run("game.penalize red1 holding"),
            "control_game { action: PENALIZE robot: \"red1\" reason: \"holding\" }");
  EXPECT_EQ(desk_.run("game.return red1"), "control_game { action: RETURN robot: \"red1\" }");
  EXPECT_EQ(desk_.run("game.return ''"), "game.request: the robot is not named");
  EXPECT_EQ(desk_.run("game.penalize ''"), "game.request: the robot is not named");
}

TEST_F(GameCommandsTest, goalsAreWholeNumbers) {
  EXPECT_EQ(desk_.run("game.score red 0"), "control_game { action: SCORE team: \"red\" }");
  EXPECT_EQ(desk_.run("game.score red 99"), "control_game { action: SCORE team: \"red\" goals: 99 }");
  for (const char* goals : {"1.5", "-1"}) {
    EXPECT_EQ(desk_.run("game.score red " + std::string(goals)),
              "game.request: the number of goals must be a whole number, 0 or more")
        << goals;
  }
  for (const char* goals : {"100", "4294967297", "1e300"})
    EXPECT_EQ(desk_.run("game.score red " + std::string(goals)),
              "game.request: a team can have at most 99 goals")
        << goals;
  EXPECT_EQ(desk_.run("game.score '' 1"), "game.request: the team is not named");
  EXPECT_THAT(desk_.asked, IsEmpty());
}

TEST_F(GameCommandsTest, theRefereeAndTheRadioAreSet) {
  EXPECT_EQ(desk_.run("game.kick-off blue"), "control_game { action: KICK_OFF team: \"blue\" }");
  EXPECT_EQ(desk_.run("game.automatic on"), "control_game { action: AUTOMATIC on: true }");
  EXPECT_EQ(desk_.run("game.automatic off"), "control_game { action: AUTOMATIC }");
  EXPECT_EQ(desk_.run("game.radio 3 0.1 0.5"),
            "control_game { action: RADIO radio { range: 3 delay: 0.1 loss: 0.5 } }");
  EXPECT_THAT(desk_.run("game.radio 3 0.1 2"), testing::StartsWith("game.request: "));
}

TEST_F(GameCommandsTest, whatThereIsInTheGameIsOffered) {
  for (const char* command : {"game.penalize", "game.return", "game.score", "game.kick-off"})
    EXPECT_THAT(desk_.offered(command), IsEmpty()) << "without a game";
  robotcontrol::GameStatus status;
  status.add_players()->set_robot("red1");
  status.add_players()->set_robot("blue2");
  status.mutable_state()->add_teams()->set_name("red");
  status.mutable_state()->add_teams()->set_name("blue");
  status.add_reasons("holding");
  desk_.publish("game", status);
  EXPECT_THAT(desk_.offered("game.penalize"), ElementsAre("red1", "blue2"));
  EXPECT_THAT(desk_.offered("game.penalize", {"red1"}), ElementsAre("holding"));
  EXPECT_THAT(desk_.offered("game.return"), ElementsAre("red1", "blue2"));
  EXPECT_THAT(desk_.offered("game.return", {"red1"}), IsEmpty());
  EXPECT_THAT(desk_.offered("game.score"), ElementsAre("red", "blue"));
  EXPECT_THAT(desk_.offered("game.score", {"red"}), IsEmpty());
}

}  // namespace
}  // namespace app
