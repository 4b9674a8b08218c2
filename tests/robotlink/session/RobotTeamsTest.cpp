// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/RobotTeams.h"

#include <gmock/gmock.h>

#include "robotcontrol/World.pb.h"

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A session whose scene says which robot is of which team.
class RobotTeamsTest : public testing::Test {
 protected:
  RobotTeamsTest() {
    session.setRobots({"blue2", "red1", "blue1", "judge", "guest"});
    auto objects = std::make_shared<robotcontrol::WorldObjects>();
    for (const auto& [name, team] : {std::pair("red1", "blue"), std::pair("blue1", "green"),
                                     std::pair("blue2", "blue"), std::pair("judge", "")}) {
      auto& robot = *objects->add_objects();
      robot.set_path(name);
      auto& property = *robot.add_properties();
      property.set_name("team");
      property.set_text(team);
    }
    session.push({"objects", Instant(fromSeconds(1)), objects});
    session.tick();
  }
  Session session;
};

TEST_F(RobotTeamsTest, theTeamIsWhatTheSceneSays) {
  const auto team = [&](const char* robot, double at) {
    return teamOf(session.store(), robot, Instant(fromSeconds(at)));
  };
  EXPECT_FALSE(team("red1", 0.5)) << "old logs do not say it";
  EXPECT_EQ(team("red1", 2), "blue");
  EXPECT_EQ(team("judge", 2), "");
  EXPECT_FALSE(team("guest", 2)) << "it is not of this scene";
}

TEST_F(RobotTeamsTest, aNameStandsForARobotOrForATeam) {
  EXPECT_THAT(teamNames(session), ElementsAre("blue", "green"));
  EXPECT_THAT(robotsNamed(session, "blue"), ElementsAre("blue2", "red1"));
  EXPECT_THAT(robotsNamed(session, "blue1"), ElementsAre("blue1"));
  EXPECT_THAT(robotsNamed(session, "red"), IsEmpty());
  EXPECT_THAT(robotsNamed(session, ""), IsEmpty()) << "robots without a team are none";
}

}  // namespace
}  // namespace robotlink
