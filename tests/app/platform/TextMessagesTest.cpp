// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/TextMessages.h"

#include <gtest/gtest.h>

#include <sstream>

#include "foxglove/Robot.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/debugging/SharedDebugQueue.h"

using namespace app;

namespace {

robotlink::SharedDebugMessage textFrom(const std::string& source, const std::string& text, double seconds) {
  auto log = std::make_shared<foxglove::Log>();
  log->set_name(source);
  log->set_message(text);
  robotlink::SharedDebugMessage message;
  message.time = robotlink::Instant(robotlink::fromSeconds(seconds));
  message.content = log;
  return message;
}

}  // namespace

TEST(TextMessages, aTextHasItsTimeToTheMillisecond) {
  std::ostringstream out;
  printText(out, robotlink::Instant(robotlink::fromSeconds(12.3456)), "game", "Goal");
  EXPECT_EQ(out.str(), "12.346  game: Goal\n");
}

TEST(TextMessages, onlyTheTextsOfAQueueArePrinted) {
  robotlink::SharedDebugQueue queue;
  queue.messages.push_back(textFrom("cognition", "sees the ball", 1));
  queue.messages.emplace_back().content = std::make_shared<foxglove::JointStates>();
  queue.messages.push_back(textFrom("motion", "walks", 1.5));
  std::ostringstream out;
  printTexts(out, "red1", queue);
  EXPECT_EQ(out.str(), "1.000  red1/cognition: sees the ball\n1.500  red1/motion: walks\n");
}

TEST(TextMessages, whatSomebodyElseWroteDoesNothingToATerminal) {
  std::ostringstream out;
  printText(out, robotlink::Instant(), "red1/motion\x1B", "a\x1B[2J\nb");
  EXPECT_EQ(out.str(), "0.000  red1/motion?: a?[2J\n    b\n");
  robotlink::GroundMap map;
  map.notes = {"a\x1B[2J"};
  printMapNotes(out, &map);
  EXPECT_NE(out.str().find("Note: a?[2J\n"), std::string::npos);
}

TEST(TextMessages, theNotesOfAMapAreWarningsIfItWasReadIncompletely) {
  robotlink::GroundMap map;
  map.notes = {"two lines have no length"};
  std::ostringstream out;
  printMapNotes(out, &map);
  map.incomplete = true;
  printMapNotes(out, &map);
  printMapNotes(out, nullptr);
  EXPECT_EQ(out.str(), "Note: two lines have no length\nWarning: two lines have no length\n");
}
