// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the ERS-210 walks with the gait that is shipped, against what was requested. All directions are
// tested, with the tolerance of the gait, in tests/modules/motion/WalkingTest.cpp.
#include <gtest/gtest.h>

#include "tests/modules/motion/WalkingRobot.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

TEST(GaitTruth, theShippedGaitWalksAsFastAsItIsAsked) {
  modules::WalkingRobot::Options options;
  options.resources = ROBOTCONTROL_SOURCE_DIR "/resources";
  options.gait = modules::shippedGait(options.resources, modules::FootMode::kRectangle);
  modules::WalkingRobot robot(options);
  robot.placeBall({-1, 1});
  const auto forward = robot.walk({0.1, 0, 0}, 5);
  compare({"ERS-210 walking forward, speed over 5 s", "what was requested", 0.1, 0.02, "m/s"},
          forward.speed.x);
  compare({"ERS-210 walking forward, speed aside", "0", 0, 0.012, "m/s"}, forward.speed.y);
  compare({"ERS-210 walking to the left, speed over 5 s", "what was requested", 0.1, 0.02, "m/s"},
          robot.walk({0, 0.1, 0}, 5).speed.y);
  compare({"ERS-210 turning, rate over 5 s", "what was requested", 1, 0.2, "rad/s"},
          robot.walk({0, 0, 1}, 5).speed.rotation);
}

}  // namespace
}  // namespace simcore::truth
