// SPDX-License-Identifier: GPL-3.0-or-later
// How the Pioneer drives, by forces.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/DriveScenes.h"

namespace simcore {
namespace {

using robotlink::degrees;
using robotlink::kPi;
using robotlink::radians;

/// By what the robot turned, from its rims' travel and its change of heading, in what follows `from`.
class TrackMeter {
 public:
  explicit TrackMeter(DrivenWorld& world) : world_(world), heading_(world.pose().heading), start_(turned()) {}
  double track() const {
    return (turned() - start_) / std::remainder(world_.pose().heading - heading_, 2 * kPi);
  }

 private:
  double turned() const { return world_->wheelState(0).rightTravel - world_->wheelState(0).leftTravel; }

  DrivenWorld& world_;
  double heading_, start_;
};

TEST(Drive, straightIsStraightWithinOnePercent) {
  DrivenWorld world(pioneerAt("p3at1", 0, 0));
  world.drive(0.5, 0.5, 12);
  world.drive(0, 0, 2);
  const robotlink::Pose2 end = world.pose();
  EXPECT_GT(end.x, 5);
  EXPECT_LT(std::abs(end.y), 0.01 * end.x);
  EXPECT_LT(std::abs(degrees(end.heading)), 0.5);
  EXPECT_NEAR(world->wheelState(0).leftTravel, end.x, 0.01 * end.x);
  EXPECT_NEAR(world->wheelState(0).rightTravel, end.x, 0.01 * end.x);
}

TEST(Drive, onTheSpotItTurnsAboutItsTrackHoweverFast) {
  for (const double rate : {5.0, 20.0, 50.0, 100.0}) {
    DrivenWorld world(pioneerAt("p3at1", 0, 0));
    const double speed = radians(rate) * world->drives()[0].track / 2;
    world.drive(-speed, speed, 3);
    const TrackMeter meter(world);
    world.drive(-speed, speed, 0.8);
    EXPECT_NEAR(meter.track(), 0.588, 0.588 * 0.02) << rate << " degrees/s";
    EXPECT_LT(world.pose().translation().norm(), 0.02) << rate << " degrees/s";
  }
}

TEST(Drive, inCurvesItTurnsAboutItsTrack) {
  DrivenWorld world(pioneerAt("p3at1", 0, 0));
  world.drive(0.3, 0.5, 3);
  const TrackMeter meter(world);
  world.drive(0.3, 0.5, 3);
  EXPECT_NEAR(meter.track(), 0.588, 0.588 * 0.03);
}

}  // namespace
}  // namespace simcore
