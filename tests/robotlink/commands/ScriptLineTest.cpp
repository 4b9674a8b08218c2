// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptLine.h"

#include <gmock/gmock.h>

using namespace robotlink;
using testing::HasSubstr;
using LineKind = ScriptLine::Kind;

namespace {

ScriptLine readLine(const std::string& line) {
  const auto result = readScriptLine(line);
  EXPECT_TRUE(result) << line << ": " << result.error().text;
  return result ? *result : ScriptLine{};
}

Error wrongLine(const std::string& line) {
  const auto result = readScriptLine(line);
  EXPECT_FALSE(result) << line;
  return result ? Error{} : result.error();
}

Result<std::string> substituted(const std::string& line) {
  return withVariables(line, [](const std::string& name) -> std::optional<std::string> {
    if (name == "robot") return "red1";
    return std::nullopt;
  });
}

}  // namespace

TEST(ScriptLine, emptyLinesAndCommentsAreNothing) {
  for (const char* line : {"", "  \t", "# simulation.start", "  # wait 1"})
    EXPECT_EQ(readLine(line).kind, LineKind::kNothing) << line;
}

TEST(ScriptLine, aLineOfAnotherWordIsACommand) {
  const ScriptLine line = readLine("  robot.key 'a # b' always  # the ball");
  EXPECT_EQ(line.kind, LineKind::kCommand);
  EXPECT_EQ(line.text, "robot.key 'a # b' always");
  EXPECT_EQ(line.column, 3);
  EXPECT_EQ(readLine("screenshot image a.png").text, "view.screenshot image a.png");
}

TEST(ScriptLine, conditionsReachToTheEndOfTheLine) {
  const ScriptLine check = readLine("assert  hosting.state == \"RUN # 1\"  # it runs");
  EXPECT_EQ(check.kind, LineKind::kAssert);
  EXPECT_EQ(check.text, "hosting.state == \"RUN # 1\"");
  EXPECT_EQ(check.column, 9);
  const ScriptLine wait = readLine("wait until simulation.time > 5 for 12.5");
  EXPECT_EQ(wait.kind, LineKind::kWaitUntil);
  EXPECT_EQ(wait.text, "simulation.time > 5");
  EXPECT_EQ(wait.seconds, 12.5);
  EXPECT_EQ(wait.column, 12);
  EXPECT_EQ(readLine("wait until a.b > 5").seconds, kDefaultScriptWait);
  EXPECT_EQ(readLine("wait until a.b == \"x for 5\"").text, "a.b == \"x for 5\"");
}

TEST(ScriptLine, theOtherWordsHaveTheirArguments) {
  EXPECT_EQ(readLine("wait 2.5").seconds, 2.5);
  EXPECT_EQ(readLine("wait 2.5 # a while").kind, LineKind::kWait);
  const ScriptLine set = readLine("set file 'a b.mcap'");
  EXPECT_EQ(set.kind, LineKind::kSet);
  EXPECT_EQ(set.text, "file");
  EXPECT_EQ(set.value, "a b.mcap");
  EXPECT_EQ(readLine("include \"common lines\"").text, "common lines");
}

TEST(ScriptLine, whatIsWrongIsSaidWithItsColumn) {
  EXPECT_THAT(wrongLine("wait").text, HasSubstr("number of seconds"));
  EXPECT_EQ(wrongLine("wait -1").where.column, 6);
  EXPECT_EQ(wrongLine("wait 1 2").where.column, 6);
  EXPECT_THAT(wrongLine("wait until").text, HasSubstr("needs a condition"));
  EXPECT_THAT(wrongLine("wait until for 3").text, HasSubstr("needs a condition"));
  EXPECT_THAT(wrongLine("assert # nothing").text, HasSubstr("needs a condition"));
  EXPECT_EQ(wrongLine("set a").where.column, 1);
  EXPECT_EQ(wrongLine("set a-b c").where.column, 5);
  EXPECT_EQ(wrongLine("include a b").where.column, 1);
  EXPECT_EQ(wrongLine("set 'a").where.column, 5);
}

TEST(ScriptLine, variablesAreReplacedExceptInSingleQuotes) {
  EXPECT_EQ(substituted("a $robot/b ${robot}2 '$robot' \"$robot\" $$robot $5 $").value(),
            "a red1/b red12 '$robot' \"red1\" $robot $5 $");
  EXPECT_EQ(substituted("log.text =~ \"lost\\$robot $robot's\"").value(),
            "log.text =~ \"lost\\$robot red1's\"");
  EXPECT_EQ(substituted("wait 1  # for $nobody").value(), "wait 1  ");
  EXPECT_EQ(substituted("go $nobody").error().where.column, 4);
  EXPECT_THAT(substituted("go $nobody").error().text, HasSubstr("there is no variable nobody"));
  EXPECT_EQ(substituted("go ${robot").error().where.column, 4);
}
