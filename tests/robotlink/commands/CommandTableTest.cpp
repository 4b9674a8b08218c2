// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandTable.h"

#include <gmock/gmock.h>

#include <cmath>

#include "robotlink/commands/CommandLine.h"

using namespace robotlink;
using testing::ElementsAre;
using testing::HasSubstr;
using Value = CommandTable::Value;
using Type = CommandTable::Type;

namespace {

class CommandTableTest : public testing::Test {
 protected:
  CommandTableTest() {
    const auto remember = [this](const std::vector<Value>& arguments) -> Result<void> {
      ran_.push_back(arguments);
      return {};
    };
    table_.add(
        {"simulation.speed", "Sets the speed.", {{"factor", Type::kNumber, "times real time"}}, remember});
    table_.add({"simulation.start", "Starts it.", {}, remember});
    table_.add({"solution.select",
                "Chooses.",
                {{"task", Type::kText, ""}, {"solution", Type::kText, ""}},
                remember});
    table_.add({"robot.stop", "Stops it.", {{"engaged", Type::kBool, ""}}, remember});
    table_.add({"log.open", "Fails.", {}, [](const auto&) -> Result<void> {
                  return failure("log.none", "no log");
                }});
  }
  std::string error(const std::string& line) {
    const auto result = table_.runLine(line);
    return result ? "" : result.error().text;
  }

  CommandTable table_;
  std::vector<std::vector<Value>> ran_;
};

}  // namespace

TEST_F(CommandTableTest, aCommandRunsWithItsArguments) {
  ASSERT_TRUE(table_.run("simulation.speed", {2.5}).has_value());
  ASSERT_EQ(ran_.size(), 1U);
  EXPECT_THAT(ran_[0], ElementsAre(Value(2.5)));
}

TEST_F(CommandTableTest, aLineIsReadByTheTypesOfTheCommand) {
  EXPECT_EQ(error("simulation.speed 2"), "");
  EXPECT_EQ(error("  solution.select ball-percept \"scan lines\"  # the fast one"), "");
  EXPECT_EQ(error("robot.stop off"), "");
  EXPECT_EQ(error("simulation.start"), "");
  EXPECT_EQ(error("solution.select 1 ''"), "");
  EXPECT_THAT(ran_,
              ElementsAre(ElementsAre(Value(2.0)),
                          ElementsAre(Value(std::string("ball-percept")), Value(std::string("scan lines"))),
                          ElementsAre(Value(false)), ElementsAre(),
                          ElementsAre(Value(std::string("1")), Value(std::string("")))));
}

TEST_F(CommandTableTest, emptyLinesAndCommentsDoNothing) {
  EXPECT_EQ(error(""), "");
  EXPECT_EQ(error("   \t"), "");
  EXPECT_EQ(error("# simulation.start"), "");
  EXPECT_TRUE(ran_.empty());
}

TEST_F(CommandTableTest, errorsSayWhatTheCommandTakes) {
  EXPECT_EQ(
      error("simulation.speed"),
      "simulation.speed takes 1 argument, 0 were given: simulation.speed <factor: number, times real time>");
  EXPECT_EQ(error("simulation.start now"),
            "simulation.start takes no arguments, 1 was given: simulation.start");
  EXPECT_EQ(error("simulation.speed fast"),
            "the argument factor must be a number, not \"fast\": simulation.speed <factor: number, times "
            "real time>");
  EXPECT_THAT(error("robot.stop maybe"), HasSubstr("must be on or off, not \"maybe\""));
  EXPECT_THAT(error("simulation.speed 2x"), HasSubstr("must be a number"));
  EXPECT_THAT(error("simulation.speed nan"), HasSubstr("must be a number"));
  EXPECT_EQ(error("solution.select \"ball"), "the quote at column 17 is not closed");
  EXPECT_TRUE(ran_.empty());
}

TEST_F(CommandTableTest, anUnknownCommandIsRefusedNamingThoseOfItsGroup) {
  EXPECT_EQ(error("simulation.go"),
            "there is no command simulation.go; there are simulation.speed, simulation.start");
  EXPECT_EQ(error("nothing"), "there is no command nothing");
  EXPECT_EQ(table_.run("simulation.go").error().id, "command.unknown");
}

TEST_F(CommandTableTest, argumentsOfAnotherTypeAreRefused) {
  EXPECT_EQ(table_.run("simulation.speed", {std::string("2")}).error().id, "command.argument-type");
  EXPECT_EQ(table_.run("simulation.speed", {true}).error().id, "command.argument-type");
  EXPECT_EQ(table_.run("simulation.speed", {1.0, 2.0}).error().id, "command.argument-count");
  EXPECT_TRUE(ran_.empty());
}

TEST_F(CommandTableTest, whatACommandFailsWithIsHandedOn) {
  EXPECT_EQ(table_.runLine("log.open").error().id, "log.none");
}

TEST_F(CommandTableTest, aNameThatIsAddedTwiceEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(table_.add({"robot.stop", "", {}, {}}), "command \"robot.stop\": added twice");
}

TEST_F(CommandTableTest, whatIsLeftOutHasItsDefault) {
  table_.add({"log.add",
              "Adds.",
              {{"file"}, {"offset", Type::kNumber, "seconds", 0.5}, {.name = "note", .mayBeMissing = true}},
              [this](const auto& values) -> Result<void> {
                ran_.push_back(values);
                return {};
              }});
  EXPECT_EQ(error("log.add a"), "");
  EXPECT_EQ(error("log.add a 2 b"), "");
  EXPECT_THAT(ran_, ElementsAre(ElementsAre(Value(std::string("a")), Value(0.5)),
                                ElementsAre(Value(std::string("a")), Value(2.0), Value(std::string("b")))));
  EXPECT_THAT(error("log.add"), HasSubstr("log.add takes 1 to 3 arguments, 0 were given"));
  EXPECT_EQ(argumentsInWords(*table_.find("log.add")), "<file: text> [offset: number = 0.5] [note: text]");
}

TEST_F(CommandTableTest, aNumberBeforeOthersMayBeMissing) {
  const auto number = [](const char* name) {
    return CommandTable::Argument{.name = name, .type = Type::kNumber, .mayBeMissing = true};
  };
  table_.add(
      {"sensor.errors", "", {{"sensor"}, number("noise"), number("delay")}, [this](const auto& values) {
         ran_.push_back(values);
         return Result<void>();
       }});
  EXPECT_EQ(error("sensor.errors psd --delay 0.5"), "");
  ASSERT_EQ(ran_.at(0).size(), 3U);
  EXPECT_TRUE(std::isnan(std::get<double>(ran_[0][1])));
  EXPECT_EQ(ran_[0][2], Value(0.5));
  EXPECT_EQ(error("sensor.errors psd"), "");
  EXPECT_EQ(ran_.at(1).size(), 1U);
}

TEST_F(CommandTableTest, aChoiceIsOneOfThem) {
  table_.add(
      {"log.images", "", {{.name = "coding", .choices = {"png", "jpeg"}}}, [](const auto&) -> Result<void> {
         return {};
       }});
  EXPECT_EQ(error("log.images jpeg"), "");
  EXPECT_EQ(error("log.images gif"),
            "the argument coding must be png or jpeg, not \"gif\": log.images <coding: png|jpeg>");
  EXPECT_FALSE(table_.run("log.images", {std::string("gif")}));
}

TEST_F(CommandTableTest, errorsHaveTheColumn) {
  const auto column = [this](const std::string& line) { return table_.runLine(line).error().where.column; };
  EXPECT_EQ(column("  fly"), 3);
  EXPECT_EQ(column("simulation.speed fast"), 18);
  EXPECT_EQ(column("simulation.speed 1 2"), 20);
  EXPECT_EQ(column("solution.select \"ball"), 17);
}

TEST_F(CommandTableTest, handlersAreAttachedWhereTheyLive) {
  table_.add({"view.show", "Shows a view.", {{"view"}}});
  EXPECT_THAT(table_.unattached(), ElementsAre("view.show"));
  EXPECT_EQ(table_.runLine("view.show image").error().id, "command.unattached");
  bool ran = false;
  table_.attach("view.show", [&](const auto&) -> Result<void> {
    ran = true;
    return {};
  });
  EXPECT_EQ(error("view.show image"), "");
  EXPECT_TRUE(ran);
  EXPECT_TRUE(table_.isAttached("view.show"));
}

TEST_F(CommandTableTest, aHandlerWithoutADeclarationEndsTheProgramWithAReason) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(table_.attach("view.show", {}), "command \"view.show\": has a handler, but is not declared");
  EXPECT_DEATH(table_.attach("robot.stop", {}), "command \"robot.stop\": has a handler already");
  EXPECT_DEATH(table_.add({"a.b", "", {{"x", Type::kText, "", std::string()}, {"y"}}}),
               "follows an optional one");
}

TEST(CommandLine, quotesAndBackslashesDoWhatTheHeaderSays) {
  const auto words = splitCommandLine("a'b c'd \"e \\\"f\\\\\" 'g\\' h#i C:\\x").value();
  std::vector<std::string> texts;
  for (const CommandWord& word : words) texts.push_back(word.text);
  EXPECT_THAT(texts, ElementsAre("ab cd", "e \"f\\", "g\\", "h#i", "C:\\x"));
  EXPECT_EQ(words[1].column, 9);
}

TEST(CommandLine, aQuotedWordIsReadAsItWas) {
  for (const std::string text :
       {"", "plain", "two words", "it's", "a \"b\" c's\\", "#", "line\nfeed", "C:\\x"}) {
    const auto words = splitCommandLine(quotedWord(text));
    ASSERT_TRUE(words) << text;
    ASSERT_EQ(words->size(), 1U) << text;
    EXPECT_EQ(words->front().text, text);
  }
}

TEST_F(CommandTableTest, optionalArgumentsCanBeNamed) {
  std::vector<Value> ran;
  table_.add({"export.made",
              "Exports.",
              {{"file", Type::kText},
               {"from", Type::kText, "", std::string("start")},
               {"rate", Type::kNumber, "", 25.0},
               {"size", Type::kText, "", {}, {}, true}},
              [&](const auto& arguments) -> Result<void> {
                ran = arguments;
                return {};
              }});
  EXPECT_EQ(error("export.made a.avi --rate 30"), "");
  EXPECT_THAT(ran, ElementsAre(Value(std::string("a.avi")), Value(std::string("start")), Value(30.0)));
  EXPECT_EQ(error("export.made --rate=10 --from -2 a.avi"), "");
  EXPECT_THAT(ran, ElementsAre(Value(std::string("a.avi")), Value(std::string("-2")), Value(10.0)));
  EXPECT_EQ(error("export.made a.avi --size 2x2"), "");
  EXPECT_THAT(ran, ElementsAre(Value(std::string("a.avi")), Value(std::string("start")), Value(25.0),
                               Value(std::string("2x2"))));
  EXPECT_THAT(error("export.made a.avi --rate"), HasSubstr("--rate needs a value"));
  EXPECT_THAT(error("export.made a.avi --rate 1 --rate 2"), HasSubstr("rate is given twice"));
  EXPECT_THAT(error("export.made a.avi --rate fast"), HasSubstr("must be a number"));
  EXPECT_THAT(error("export.made --rate 2"), HasSubstr("takes 1 to 4 arguments"));
}

TEST_F(CommandTableTest, whatNamesNoArgumentIsAText) {
  EXPECT_EQ(error("solution.select --task x"), "");
  EXPECT_THAT(ran_.back(), ElementsAre(Value(std::string("--task")), Value(std::string("x"))));
}
