// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/HeadController.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::radians;
using robotlink::Vector3;
constexpr robotlink::Duration kHeadFrame = std::chrono::milliseconds(8);

HeadCommand desired(HeadCommand::Kind kind) {
  return {kind, {}};
}

/// The direction of the camera's axis and the point it passes through, in the robot's frame, for a level
/// body.
std::pair<Vector3, Vector3> gaze(const HeadAngles& angles, const HeadParameters& parameters) {
  const RobotDimensions d;
  const auto tilt = Eigen::AngleAxisd(-angles.tilt, Vector3::UnitY());
  const Vector3 panCenter =
      Vector3(d.neckX, 0, d.neckZ + parameters.bodyHeight) + tilt * Vector3(0, 0, d.neckLength);
  return {panCenter, tilt * (Eigen::AngleAxisd(angles.pan, Vector3::UnitZ()) * Vector3::UnitX())};
}

TEST(HeadControllerTest, theCamerasAxisGoesThroughThePoint) {
  HeadParameters parameters;
  parameters.bodyPitch = 0;
  const HeadController controller(parameters);
  for (const Vector3& point : {Vector3(0.3, 0, 0.04), Vector3(1.5, 0.8, 0.04), Vector3(0.4, -0.4, 0.3)}) {
    const auto [from, direction] = gaze(controller.anglesTowards(point), parameters);
    EXPECT_LT((point - from).cross(direction).norm(), 1e-9);
    EXPECT_GT((point - from).dot(direction), 0);
  }
}

TEST(HeadControllerTest, aPitchedBodyRaisesTheHeadByItsPitch) {
  HeadParameters parameters;
  parameters.bodyPitch = 0;
  const double level = HeadController(parameters).anglesTowards({5, 0, 0.2}).tilt;
  parameters.bodyPitch = 0.1;
  EXPECT_NEAR(HeadController(parameters).anglesTowards({5, 0, 0.2}).tilt - level, 0.1, 5e-3);
}

TEST(HeadControllerTest, whatLiesBehindTheNeckDoesNotTurnTheHeadOver) {
  const HeadController controller(HeadParameters{});
  const HeadAngles angles = controller.anglesTowards({-1, 0.2, 0.04});
  EXPECT_LT(angles.tilt, 0);
  EXPECT_GT(angles.pan, 0);
  EXPECT_TRUE(std::isfinite(controller.anglesTowards({0.075, 0, 0.165}).tilt));
}

TEST(HeadControllerTest, aKnownBallIsTrackedInSearchTooAndALostOneIsSearchedOnItsSide) {
  for (const auto kind : {HeadCommand::Kind::kSearchBall, HeadCommand::Kind::kTrackBall}) {
    HeadController controller(HeadParameters{});
    HeadAngles head = controller.advance(desired(kind), BallSight{{1, -0.5}, 0.1}, {}, kHeadFrame);
    EXPECT_EQ(controller.state(), HeadController::State::kTracking);
    EXPECT_LT(head.pan, -0.3);
    for (int i = 0; i < 130; ++i)
      head = controller.advance(desired(kind), BallSight{{1, -0.5}, 2}, head, kHeadFrame);
    EXPECT_EQ(controller.state(), HeadController::State::kSearching);
    EXPECT_LT(head.pan, -0.7);
  }
}

TEST(HeadControllerTest, afterLookingElsewhereAnOldBallIsLookedForAtItsPlace) {
  HeadController controller(HeadParameters{});
  const BallSight old{{0.25, 0.1}, 3};
  HeadAngles head;
  for (int i = 0; i < 100; ++i)
    head = controller.advance(desired(HeadCommand::Kind::kLookAround), old, head, kHeadFrame);
  EXPECT_EQ(controller.state(), HeadController::State::kSweeping);
  head = controller.advance(desired(HeadCommand::Kind::kTrackBall), old, head, kHeadFrame);
  EXPECT_EQ(controller.state(), HeadController::State::kTracking);
  EXPECT_EQ(head, controller.tracking(old.position));
}

TEST(HeadControllerTest, aNearBallIsSearchedBeforeThePawsFirst) {
  const auto tiltOfSearch = [](const robotlink::Vector2& ball) {
    HeadController controller(HeadParameters{});
    HeadAngles head;
    for (int i = 0; i < 150; ++i)
      head = controller.advance(desired(HeadCommand::Kind::kTrackBall), BallSight{ball, 5}, head, kHeadFrame);
    EXPECT_EQ(controller.state(), HeadController::State::kSearching);
    return head.tilt;
  };
  const HeadParameters parameters;
  EXPECT_NEAR(tiltOfSearch({0.25, 0.1}), parameters.searchNearTilt, 1e-6);
  EXPECT_NEAR(tiltOfSearch({1.5, 0.1}), parameters.searchFarTilt, 1e-6);
}

TEST(HeadControllerTest, aTrackedBallIsKeptLowSoThatBeaconsAreSeenToo) {
  const HeadParameters parameters;
  HeadController controller(parameters);
  const auto above = [&](const robotlink::Vector2& ball) {
    const auto kind = desired(HeadCommand::Kind::kTrackBall);
    const HeadAngles head = controller.advance(kind, BallSight{ball, 0}, {}, kHeadFrame);
    return head.tilt - controller.anglesTowards({ball.x(), ball.y(), parameters.ballRadius}).tilt;
  };
  EXPECT_NEAR(above({0.4, 0.1}), parameters.ballLow, 1e-9);
  // In the middle are one that is before the paws, and one that is as high as beacons.
  EXPECT_EQ(above({0.17, 0.03}), 0);
  EXPECT_NEAR(above({3, 0}), 0, 0.05);
}

/// Pan and tilt over some seconds, the head following at once.
struct Sweep {
  double left = -9, right = 9, up = -9, down = 9, fastest = 0;
};
Sweep swept(HeadController& controller, const HeadCommand& kind, double seconds) {
  Sweep sweep;
  HeadAngles head;
  for (int i = 0; i < static_cast<int>(seconds / 0.008); ++i) {
    const HeadAngles next = controller.advance(kind, std::nullopt, head, kHeadFrame);
    sweep.fastest = std::max(sweep.fastest, std::abs(next.pan - head.pan) / 0.008);
    head = next;
    sweep.left = std::max(sweep.left, head.pan);
    sweep.right = std::min(sweep.right, head.pan);
    sweep.up = std::max(sweep.up, head.tilt);
    sweep.down = std::min(sweep.down, head.tilt);
  }
  return sweep;
}

TEST(HeadControllerTest, searchingSweepsFarAndNearOnBothSides) {
  HeadController controller(HeadParameters{});
  const Sweep sweep = swept(controller, desired(HeadCommand::Kind::kSearchBall), 6);
  EXPECT_GT(sweep.left, radians(75));
  EXPECT_LT(sweep.right, radians(-75));
  EXPECT_LT(sweep.down, radians(-40));
  EXPECT_LT(sweep.fastest, 2);
}

TEST(HeadControllerTest, lookingAroundStaysAtTheHeightOfLandmarks) {
  HeadController controller(HeadParameters{});
  const Sweep sweep = swept(controller, desired(HeadCommand::Kind::kLookAround), 5);
  EXPECT_GT(sweep.left, radians(80));
  EXPECT_LT(sweep.right, radians(-80));
  EXPECT_GT(sweep.down, radians(-5));
}

TEST(HeadControllerTest, aSweepWaitsForAHeadThatIsHeld) {
  HeadController controller(HeadParameters{});
  HeadAngles wanted;
  for (int i = 0; i < 300; ++i) wanted = controller.lookAround({}, kHeadFrame);
  EXPECT_LT(wanted.pan, 0.6);
}

TEST(HeadControllerTest, anglesAndAheadAreObeyedAtOnce) {
  HeadController controller(HeadParameters{});
  const HeadCommand angles{HeadCommand::Kind::kAngles, {0.1, 0.2, 0.3, -0.4}};
  EXPECT_EQ(controller.advance(angles, std::nullopt, {}, kHeadFrame), angles.angles);
  EXPECT_EQ(controller.advance(desired(HeadCommand::Kind::kLookAhead), std::nullopt, {}, kHeadFrame).pan, 0);
}

}  // namespace
}  // namespace modules
