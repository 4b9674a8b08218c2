// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCompletion.h"

#include <gmock/gmock.h>

using namespace robotlink;
using testing::ElementsAre;
using testing::IsEmpty;
using Type = CommandTable::Type;

namespace {

Result<void> nothing(const CommandTable::Values&) {
  return {};
}

class CommandCompletionTest : public testing::Test {
 protected:
  CommandCompletionTest() {
    table_.add({"robot.stop", "", {{"engaged", Type::kBool}}, nothing});
    table_.add({"robot.select", "", {{"robot"}, {"why", Type::kNumber}}});
    table_.attach("robot.select", nothing, [](std::size_t) {
      return std::vector<std::string>{"red1", "blue 1", "red1"};
    });
    table_.add({"log.images", "", {{.name = "coding", .choices = {"png", "jpeg", "as-is"}}}, nothing});
    table_.add({"robot.far", "Nothing is attached to it."});
  }
  std::vector<std::string> at(const std::string& line) {
    return complete(table_, line, line.size()).candidates;
  }

  CommandTable table_;
};

}  // namespace

TEST_F(CommandCompletionTest, namesOfCommandsThatCanBeRun) {
  EXPECT_THAT(at("robot."), ElementsAre("robot.select", "robot.stop"));
  EXPECT_THAT(at(""), ElementsAre("log.images", "robot.select", "robot.stop"));
  EXPECT_THAT(at("fly"), IsEmpty());
  EXPECT_THAT(at("# rob"), IsEmpty());
}

TEST_F(CommandCompletionTest, argumentsByTypeChoicesAndWhatIsOffered) {
  EXPECT_THAT(at("robot.stop "), ElementsAre("off", "on"));
  EXPECT_THAT(at("log.images j"), ElementsAre("jpeg"));
  EXPECT_THAT(at("robot.select "), ElementsAre("'blue 1'", "red1"));
  EXPECT_THAT(at("robot.select 'bl"), ElementsAre("'blue 1'"));
  EXPECT_THAT(at("robot.stop on "), IsEmpty()) << "it takes one argument";
}

TEST_F(CommandCompletionTest, theWordAtTheCursorIsReplaced) {
  const Completion inside = complete(table_, "  log.im png", 8);
  EXPECT_EQ(inside.from, 2U);
  EXPECT_THAT(inside.candidates, ElementsAre("log.images"));
  EXPECT_EQ(inside.command, nullptr);
  const Completion argument = complete(table_, "robot.select red1 ", 100);
  EXPECT_EQ(argument.from, 18U);
  ASSERT_NE(argument.command, nullptr);
  EXPECT_EQ(argument.command->arguments[argument.argument].name, "why");
}
