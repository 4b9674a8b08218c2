// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandCompletion.h"

#include <gmock/gmock.h>

#include "tests/TestFolder.h"

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
    table_.attach("robot.select", nothing, [](const auto&) {
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

TEST_F(CommandCompletionTest, filesAndFoldersOfAPath) {
  const TestFolder folder;
  folder.write("a.log", "");
  folder.write("b/c.log", "");
  folder.write(".hidden", "");
  table_.add({"log.open", "", {{"file", Type::kFile}}, nothing});
  const std::string path = folder.path().string() + "/";
  EXPECT_THAT(at("log.open " + path), ElementsAre(path + "a.log", path + "b/"));
  EXPECT_THAT(at("log.open " + path + "b/"), ElementsAre(path + "b/c.log"));
  EXPECT_THAT(at("log.open " + path + ".h"), ElementsAre(path + ".hidden"));
  EXPECT_THAT(at("log.open " + path + "none/"), IsEmpty());
}

TEST_F(CommandCompletionTest, whatIsOfferedMayDependOnTheArgumentsBefore) {
  table_.add({"set", "", {{"task"}, {"solution"}}});
  table_.attach("set", nothing, [](const auto& before) {
    return before.empty() ? std::vector<std::string>{"walk"}
                          : std::vector<std::string>{before.front() + "-1"};
  });
  EXPECT_THAT(at("set "), ElementsAre("walk"));
  EXPECT_THAT(at("set walk "), ElementsAre("walk-1"));
}

TEST_F(CommandCompletionTest, optionalArgumentsAreNamed) {
  table_.add({"export.made",
              "",
              {{"file", Type::kFile},
               {"rate", Type::kNumber, "", 25.0},
               {.name = "kind", .initial = std::string("a"), .choices = {"a", "b"}}},
              nothing});
  EXPECT_THAT(at("export.made x --"), ElementsAre("--kind", "--rate"));
  EXPECT_THAT(at("export.made x --kind "), ElementsAre("a", "b"));
  EXPECT_THAT(at("export.made x --rate 5 "), ElementsAre()) << "a number is next";
}
