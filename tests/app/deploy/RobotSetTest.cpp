// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/RobotSet.h"

#include <gmock/gmock.h>

namespace app {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(RobotSet, isReadAsItWasWritten) {
  RobotSet set{"Home \"game\": #1", {}};
  EXPECT_EQ(parseRobotSet(toText(set), "set.yaml").value(), set);
  set.robots.push_back({"red1", "red", "goalie", "wss://192.168.1.7:8765", "layouts/own.yaml", "hall.c64",
                        "parameters/ers210", "motions", "penalty.preset.json"});
  set.robots.push_back({"blåe: 2", "", "", "ws://[::1]:1", "", "", "", ""});
  const std::string text = toText(set);
  const auto again = parseRobotSet(text, "set.yaml");
  ASSERT_TRUE(again) << robotlink::describe(again.error());
  EXPECT_EQ(*again, set);
  EXPECT_EQ(toText(*again), text);
}

TEST(RobotSet, allMistakesAreSaidWithTheirLines) {
  const auto set = parseRobotSet(R"(robot-set: 1
name: Home
robots:
  - name: red1
    address: http://192.168.1.7
  - name: red1
    address: ws://192.168.1.8
    colour-table: hall.c64
  - address: ws://192.168.1.9
)",
                                 "set.yaml");
  ASSERT_FALSE(set);
  const std::string errors = robotlink::describe(set.error());
  EXPECT_THAT(errors, AllOf(HasSubstr("set.yaml:5"), HasSubstr("ws://"), HasSubstr("set.yaml:6"),
                            HasSubstr("another robot 'red1'"), HasSubstr("set.yaml:8"),
                            HasSubstr("colour-table"), HasSubstr("set.yaml:9"), HasSubstr("name")))
      << errors;
}

TEST(RobotSet, anEmptyNameOrAddressIsNone) {
  RobotSet set{"Home", {{.name = "", .address = "ws://192.168.1.7:8765"}}};
  const auto nameless = parseRobotSet(toText(set), "set.yaml");
  ASSERT_FALSE(nameless) << "its color table would be a hidden file";
  EXPECT_THAT(robotlink::describe(nameless.error()), HasSubstr("set.yaml:5:11: a robot needs a name"));
  set.robots.front() = {.name = "red1"};
  const auto nowhere = parseRobotSet(toText(set), "set.yaml");
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(robotlink::describe(nowhere.error()), HasSubstr("set.yaml:6"));
}

TEST(RobotSet, ofANewerVersionOrNoneIsRefused) {
  for (const char* text : {"", "name: a\nrobots: []\n", "robot-set: 2\nname: a\nrobots: []\n", "[]", "a: [",
                           "robot-set: 1\nname: a\nrobots: 3\n"})
    EXPECT_FALSE(parseRobotSet(text, "set.yaml")) << text;
}

}  // namespace
}  // namespace app
