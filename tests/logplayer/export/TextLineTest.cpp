// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/TextLine.h"

#include <gtest/gtest.h>

#include "foxglove/Robot.pb.h"

namespace logplayer {
namespace {

using foxglove::Log;

std::string lineOf(Log::Level level, const std::string& name, const std::string& text,
                   robotlink::Duration time = std::chrono::milliseconds(1500)) {
  Log log;
  log.set_level(level);
  log.set_name(name);
  log.set_message(text);
  return textLine({"red1/log", robotlink::Instant(time), nullptr}, log);
}

TEST(TextLine, aTextHasItsTimeLevelAndSource) {
  EXPECT_EQ(lineOf(Log::INFO, "cognition/ball", "seen"),
            "    1.500000  info     red1/cognition/ball: seen\n");
  EXPECT_EQ(lineOf(Log::WARNING, "", "hot"), "    1.500000  warning  red1/log: hot\n");
}

TEST(TextLine, levelsHaveWords) {
  struct Case {
    Log::Level level;
    const char* word;
  };
  for (const Case& one : {Case{Log::DEBUG, "debug"}, Case{Log::INFO, "info"}, Case{Log::WARNING, "warning"},
                          Case{Log::ERROR, "error"}, Case{Log::FATAL, "fatal"}, Case{Log::UNKNOWN, "-"}})
    EXPECT_NE(lineOf(one.level, "", "x").find(std::string("  ") + one.word + " "), std::string::npos)
        << one.word;
}

TEST(TextLine, furtherLinesAreIndentedAndNothingReachesATerminal) {
  EXPECT_EQ(lineOf(Log::ERROR, "", "one\ntwo"), "    1.500000  error    red1/log: one\n    two\n");
  EXPECT_EQ(lineOf(Log::ERROR, "", "\x1b[31mred").find('\x1b'), std::string::npos);
}

TEST(TextLine, wallClocksAreDates) {
  const std::string line = lineOf(Log::INFO, "", "x", std::chrono::hours(24) * 365 * 40);
  EXPECT_EQ(line.substr(0, 5), "2009-");
}

}  // namespace
}  // namespace logplayer
