// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/LandmarkGeometry.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

class LandmarkGeometryTest : public testing::Test {
 protected:
  LandmarkGeometryTest()
      : field(*robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml")),
        geometry(field, {}) {
    view.cameraInRobot = Pose3(Eigen::Translation3d(0, 0, 0.2));
  }
  /// The box that something upright would have: `size` is width and height, m, `bottom` its height above
  /// ground.
  ImageBox boxOf(double distance, double left, double width, double bottom, double height) const {
    const auto lower = *view.pixelOf({distance, left + width / 2, bottom});
    const auto upper = *view.pixelOf({distance, left - width / 2, bottom + height});
    return {lower.x(), upper.y(), upper.x(), lower.y()};
  }
  ImageBox beaconAt(double distance, double left = 0) const {
    return boxOf(distance, left, 2 * field.beaconRadius, field.beaconBaseHeight, 2 * field.beaconBandHeight);
  }
  ImageBox goalAt(double distance) const { return boxOf(distance, 0, field.goalWidth, 0, field.goalHeight); }

  robotlink::FieldDescription field;
  LandmarkGeometry geometry;
  CameraView view;
  const FieldLandmark beacon{FieldLandmark::Kind::kBeacon, "beacon", {}, 1, 2};
  const FieldLandmark goal{FieldLandmark::Kind::kGoal, "goal", {}, 1, 1};
};

TEST_F(LandmarkGeometryTest, aBeaconIsLocatedByItsHeight) {
  for (const double distance : {1.0, 2.0, 4.0}) {
    const auto seen = geometry.locate(beacon, beaconAt(distance, 0.2), view);
    ASSERT_TRUE(seen) << distance;
    EXPECT_NEAR(seen->distance, std::hypot(distance, 0.2), 0.02 * distance);
    EXPECT_NEAR(seen->bearing, std::atan2(0.2, distance), 0.01);
  }
}

TEST_F(LandmarkGeometryTest, aGoalIsLocatedByItsHeight) {
  const auto seen = geometry.locate(goal, goalAt(3), view);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->distance, 3, 0.05);
  EXPECT_NEAR(seen->bearing, 0, 0.01);
}

TEST_F(LandmarkGeometryTest, aBeaconThatIsCutOffAtTheTopIsLocatedByItsWidthAndTrustedLess) {
  ImageBox box = beaconAt(1);
  box.top = 0;
  const auto cut = geometry.locate(beacon, box, view);
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->distance, 1, 0.3);
  EXPECT_LT(cut->confidence, geometry.locate(beacon, beaconAt(1), view)->confidence);
}

TEST_F(LandmarkGeometryTest, aGoalThatIsCutOffAtASideIsOfNoUse) {
  ImageBox box = goalAt(3);
  box.left = 0;
  EXPECT_FALSE(geometry.locate(goal, box, view));
  box = beaconAt(2);
  box.left = 0;
  box.bottom = view.height;
  EXPECT_FALSE(geometry.locate(beacon, box, view)) << "in a corner nothing is known about a beacon either";
}

TEST_F(LandmarkGeometryTest, whatStandsOnTheGroundOrHangsInTheAirIsNoBeacon) {
  ImageBox box = beaconAt(1);
  const double height = box.height();
  box.top -= 1.5 * height, box.bottom -= 1.5 * height;
  box.top = std::max(box.top, 1.0);
  EXPECT_FALSE(geometry.locate(beacon, box, view));
}

TEST_F(LandmarkGeometryTest, aWideBoxIsNoBeacon) {
  ImageBox box = beaconAt(1);
  const double width = box.width();
  box.left -= width, box.right += width;
  EXPECT_FALSE(geometry.locate(beacon, box, view));
}

TEST_F(LandmarkGeometryTest, aSlimBoxIsNoGoal) {
  ImageBox box = goalAt(2.5);
  box.left = box.center().x() - 2;
  box.right = box.left + 4;
  EXPECT_FALSE(geometry.locate(goal, box, view));
}

TEST_F(LandmarkGeometryTest, aBandOfABeaconIsNoGoal) {
  for (const double distance : {0.6, 1.0, 2.0}) {
    const ImageBox band =
        boxOf(distance, 0, 2 * field.beaconRadius, field.beaconBaseHeight, field.beaconBandHeight);
    EXPECT_FALSE(geometry.locate(goal, band, view)) << distance;
    ImageBox cut = band;
    cut.top = 0;
    EXPECT_FALSE(geometry.locate(goal, cut, view)) << distance;
  }
}

TEST_F(LandmarkGeometryTest, whatIsTooSmallOrTooFarIsIgnored) {
  EXPECT_FALSE(geometry.locate(beacon, {80, 60, 82, 63}, view));
  EXPECT_FALSE(geometry.locate(beacon, {80, 60, 80.5, 80}, view));
  LandmarkGeometry::Options near;
  near.maximumDistance = 1.5;
  EXPECT_FALSE(LandmarkGeometry(field, near).locate(beacon, beaconAt(2), view));
  EXPECT_TRUE(LandmarkGeometry(field, near).locate(beacon, beaconAt(1.4), view));
}

}  // namespace
}  // namespace modules
