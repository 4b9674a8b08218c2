// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/PoseHistory.h"

#include <gtest/gtest.h>

namespace simcore {
namespace {

Pose3 at(double x, double turn = 0) {
  return Eigen::Translation3d(x, 0, 0) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
}

void addSteps(PoseHistory& history, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t step = first; step <= last; ++step) {
    const Pose3 pose = at(static_cast<double>(step));
    history.add(step, {&pose, 1});
  }
}

double xAt(const PoseHistory& history, std::uint64_t step) {
  const auto poses = history.at(step);
  return poses.empty() ? -1 : poses[0].translation().x();
}

TEST(PoseHistory, nothingIsKeptUntilSomebodyNeedsIt) {
  PoseHistory history;
  addSteps(history, 0, 5);
  EXPECT_FALSE(history.isWanted());
  EXPECT_TRUE(history.at(3).empty());
  EXPECT_EQ(history.oldest(5), 5U);
}

TEST(PoseHistory, itReachesBackAsFarAsTheLongestNeed) {
  PoseHistory history;
  history.reachBack(3);
  history.reachBack(2);
  addSteps(history, 0, 10);
  EXPECT_EQ(history.oldest(10), 7U);
  for (std::uint64_t step = 7; step <= 10; ++step) EXPECT_EQ(xAt(history, step), static_cast<double>(step));
  EXPECT_EQ(xAt(history, 2), 7) << "the next one that it has";
  EXPECT_EQ(xAt(history, 11), -1);
}

TEST(PoseHistory, itsMemoryIsBounded) {
  PoseHistory history;
  history.reachBack(1'000'000);
  addSteps(history, 0, 1000);
  EXPECT_EQ(history.oldest(1000), 1000 - PoseHistory::kMaxSteps);
}

TEST(PoseHistory, aStepThatIsRepeatedReplacesItself) {
  PoseHistory history;
  history.reachBack(5);
  addSteps(history, 0, 3);
  const Pose3 moved = at(42);
  history.add(3, {&moved, 1});
  EXPECT_EQ(xAt(history, 3), 42);
  EXPECT_EQ(xAt(history, 2), 2);
  history.clear();
  EXPECT_TRUE(history.isWanted());
  EXPECT_EQ(history.oldest(3), 3U);
}

TEST(PoseHistory, whatItWillHaveLaterIsKnown) {
  PoseHistory history;
  history.reachBack(3);
  addSteps(history, 0, 10);
  EXPECT_EQ(history.oldestAt(10), 7U);
  EXPECT_EQ(history.oldestAt(12), 9U);
}

TEST(PoseHistory, posesBetweenTwoStepsAreOnTheShortestWay) {
  const Pose3 from = at(0, 3.0), to = at(2, -3.0);
  const auto posesOf = [&](std::uint64_t step) { return std::span<const Pose3>(step == 7 ? &from : &to, 1); };
  std::vector<Pose3> poses;
  interpolatePoses(7, posesOf, poses);
  EXPECT_TRUE(poses.at(0).isApprox(from, 1e-9));
  interpolatePoses(8, posesOf, poses);
  EXPECT_TRUE(poses.at(0).isApprox(to, 1e-9));
  interpolatePoses(7.5, posesOf, poses);
  EXPECT_NEAR(poses.at(0).translation().x(), 1, 1e-12);
  // Across the half turn, not back through 0.
  EXPECT_NEAR(poses.at(0).linear()(0, 0), -1, 1e-9);
}

}  // namespace
}  // namespace simcore
