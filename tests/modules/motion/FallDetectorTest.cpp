// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/FallDetector.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Vector3;
using Side = FallDetector::Side;

void feel(FallDetector& detector, const Vector3& acceleration, int frames) {
  for (int i = 0; i < frames; ++i) detector.update(acceleration, std::chrono::milliseconds(8));
}

TEST(FallDetectorTest, theSideThatIsDownIsTold) {
  const std::pair<Vector3, Side> cases[] = {{{9.8, 0, 1}, Side::kRear},
                                            {{-9.8, 0, 1}, Side::kFront},
                                            {{0, 9.8, 1}, Side::kRight},
                                            {{0, -9.8, 1}, Side::kLeft},
                                            {{1, 1, -9.8}, Side::kBack}};
  for (const auto& [acceleration, side] : cases) {
    FallDetector detector;
    feel(detector, acceleration, 200);
    EXPECT_TRUE(detector.fallen());
    EXPECT_EQ(detector.side(), side);
    feel(detector, {0, 0, 9.8}, 200);
    EXPECT_FALSE(detector.fallen());
    EXPECT_EQ(detector.side(), Side::kNone);
  }
}

TEST(FallDetectorTest, aShortShockIsNoFall) {
  FallDetector detector;
  feel(detector, {19, 0, -5}, 15);
  feel(detector, {0, 0, 9.8}, 30);
  EXPECT_FALSE(detector.fallen());
}

TEST(FallDetectorTest, aRobotThatSitsHasFallenButOneThatLeansForAMomentHasNot) {
  // 56 degrees, as on the hind legs.
  const Vector3 sits = 9.81 * Vector3(0.829, 0, 0.559);
  FallDetector detector;
  feel(detector, sits, 60);
  EXPECT_FALSE(detector.fallen());
  feel(detector, {0, 0, 9.8}, 60);
  feel(detector, sits, 200);
  EXPECT_TRUE(detector.fallen());
  EXPECT_EQ(detector.side(), Side::kRear);
}

TEST(FallDetectorTest, brokenReadingsAreIgnored) {
  FallDetector detector;
  feel(detector, {NAN, 0, 0}, 100);
  EXPECT_FALSE(detector.fallen());
  EXPECT_EQ(detector.up(), Vector3(0, 0, 1));
}

}  // namespace
}  // namespace modules
