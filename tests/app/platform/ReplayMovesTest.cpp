// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/ReplayMoves.h"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "robotcontrol/Logging.pb.h"

using namespace app;
using robotcontrol::ControlReplay;

namespace {

ControlReplay control(const std::string& text) {
  ControlReplay result;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &result)) << text;
  return result;
}

/// What two moves are together; "both" if they remain two.
std::string joined(const std::string& first, const std::string& second) {
  ControlReplay move = control(first);
  const ControlReplay before = move;
  if (joinMoves(move, control(second))) return move.ShortDebugString();
  EXPECT_EQ(move.ShortDebugString(), before.ShortDebugString());
  return "both";
}

}  // namespace

TEST(ReplayMoves, onlyStepsAndJumpsAreMoves) {
  EXPECT_TRUE(onlyMoves(control("action: STEP_FRAME count: 1 process: 'red1/motion'")));
  EXPECT_TRUE(onlyMoves(control("action: JUMP_TO_TIME time: 5")));
  for (const char* text :
       {"", "action: PLAY", "action: STOP", "speed: 2", "action: JUMP_TO_TIME speed: 2",
        "action: STEP_FRAME packages { package: 'a' }", "action: JUMP_TO_TIME loop: false"}) {
    EXPECT_FALSE(onlyMoves(control(text))) << text;
  }
}

TEST(ReplayMoves, ofJumpsTheNewerCounts) {
  EXPECT_EQ(joined("action: JUMP_TO_TIME time: 5", "action: JUMP_TO_TIME time: 7"),
            "action: JUMP_TO_TIME time: 7");
  EXPECT_EQ(joined("action: JUMP_TO_TIME time: 5", "action: JUMP_TO_FRAME frame: 2"),
            "action: JUMP_TO_FRAME frame: 2");
  EXPECT_EQ(joined("action: STEP_FRAME count: 3", "action: JUMP_TO_TIME time: 7"),
            "action: JUMP_TO_TIME time: 7");
}

TEST(ReplayMoves, stepsOfOneKindAddUp) {
  EXPECT_EQ(joined("action: STEP_FRAME count: 3", "action: STEP_FRAME count: 1"),
            "action: STEP_FRAME count: 4");
  EXPECT_EQ(
      joined("action: STEP_MESSAGE count: -1 stream: 'a'", "action: STEP_MESSAGE count: -1 stream: 'a'"),
      "action: STEP_MESSAGE count: -2 stream: \"a\"");
  EXPECT_EQ(joined("action: STEP_FRAME count: 2147483647", "action: STEP_FRAME count: 2147483647"),
            "action: STEP_FRAME count: 2147483647");
}

TEST(ReplayMoves, whatLeadsElsewhereRemainsTwoMoves) {
  EXPECT_EQ(joined("action: STEP_FRAME count: 1", "action: STEP_FRAME count: -1"), "both");
  EXPECT_EQ(joined("action: JUMP_TO_TIME time: 5", "action: STEP_FRAME count: 1"), "both");
  EXPECT_EQ(joined("action: STEP_FRAME count: 1", "action: STEP_FRAME count: 1 process: 'red1/motion'"),
            "both");
  EXPECT_EQ(joined("action: STEP_MESSAGE count: 1 stream: 'a'", "action: STEP_MESSAGE count: 1 stream: 'b'"),
            "both");
}
