// SPDX-License-Identifier: GPL-3.0-or-later
// The robot object on a serial line of 9600 baud with noise, and with a cable that is pulled.
#include <gmock/gmock.h>

#include "robotlink/arcos/PioneerRobot.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/arcos/RobotOnSerialLine.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

struct PioneerRobotSerialTest : testing::Test {
  void begin(PioneerRobot& robot) {
    const auto begun = robot.begin();
    ASSERT_TRUE(begun) << begun.error().text;
  }

  TestFolder folder;
  PseudoTerminal line{folder / "ttyUSB0"};
  RobotOnSerialLine far{line};
};

TEST_F(PioneerRobotSerialTest, aNoisyLineLosesPacketsButNotTheRobot) {
  PioneerRobot robot(
      [&] {
        auto stream = open(line.url());
        // What a radio modem is sent by clients that think there is one: junk to the robot.
        if (stream) {
          EXPECT_TRUE((*stream)->write(std::vector<std::uint8_t>{'W', 'M', 'S', '2', '\r'}));
        }
        return stream;
      },
      std::make_shared<SteadyClock>());
  begin(robot);
  EXPECT_EQ(far.skippedBytes(), 5u);
  robot.setMotors(true);
  robot.setSpeed(0.2);
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(robot.read());
  EXPECT_GT(robot.speed(), 0.05);
  EXPECT_GE(robot.linkCounts().states, 7u);
  EXPECT_GE(robot.linkCounts().checksumErrors, 1u);
  EXPECT_GE(robot.linkCounts().skippedBytes, 3u);
}

TEST_F(PioneerRobotSerialTest, aCableThatIsPulledIsNamedAndTheRobotIsFoundAgainAmidItsOldConnection) {
  PioneerRobot robot(line.url());
  begin(robot);
  far.pull();
  Result<bool> read = true;
  while (read) read = robot.read();
  EXPECT_THAT(read.error().text, HasSubstr(line.path().string() + " is gone"));
  EXPECT_THAT(robot.begin().error().text, HasSubstr("is its cable plugged in?"));
  far.plugIn();
  begin(robot);
  EXPECT_EQ(robot.read(), true);
}

}  // namespace
}  // namespace robotlink::arcos
