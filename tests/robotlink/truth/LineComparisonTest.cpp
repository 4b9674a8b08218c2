// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/LineComparison.h"

#include <gtest/gtest.h>

#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/truth/PackageErrors.h"

namespace robotlink {
namespace {

/// A field with nothing but a halfway line, before which the robot stands: the edges are 0.9 and 1.1 m ahead.
class LineComparisonTest : public testing::Test {
 protected:
  LineComparisonTest() {
    field.length = 6;
    field.width = 3;
    field.lineWidth = 0.2;
    assign(*truth.mutable_robot_in_field(), Pose2{-1, 0, 0});
    Pose3 pose = Pose3::Identity();
    pose.translation() = Vector3(0, 0, 0.2);
    assign(*truth.mutable_camera()->mutable_camera_in_robot(), pose);
    truth.mutable_camera()->set_horizontal_angle(1);
    truth.mutable_camera()->set_vertical_angle(0.8);
  }
  void addPoint(double x, double y, double direction = kPi / 2) {
    auto& point = *percepts.add_points();
    assign(*point.mutable_position_in_robot(), Vector2(x, y));
    point.set_direction(direction);
  }
  void addSegment(const Vector2& start, const Vector2& end) {
    auto& segment = *percepts.add_segments();
    assign(*segment.mutable_start_in_robot(), start);
    assign(*segment.mutable_end_in_robot(), end);
  }
  void compare() { compareLines(percepts, truth, field, errors); }

  FieldDescription field;
  robotcontrol::OracleWorld truth;
  robotcontrol::FieldLinePercepts percepts;
  PackageErrors errors;
};

TEST_F(LineComparisonTest, pointsAreComparedWithTheNearestEdge) {
  addPoint(0.93, 0.1, kPi / 2 - 0.1);
  addPoint(1.12, -0.2, -kPi / 2);
  addPoint(0.5, 0);
  compare();
  EXPECT_EQ(errors.reported, 3U);
  EXPECT_EQ(errors.invented, 1U) << "0.4 m before the line there is none";
  EXPECT_NEAR(errors.quantities.at("points").amounts.mean(), 0.025, 1e-6);
  EXPECT_NEAR(errors.quantities.at("direction").amounts.maximum(), 0.1, 1e-6) << "lines have no sense";
  EXPECT_FALSE(errors.quantities.contains("segments"));
}

TEST_F(LineComparisonTest, whereEdgesMeetTheOneOfThatDirectionCounts) {
  field.penaltyAreaLength = 0.5;
  field.penaltyAreaWidth = 1;
  // The outer corner of a penalty area.
  for (const double direction : {0.0, kPi / 2}) {
    addPoint(1 + 0.5 * field.length - field.penaltyAreaLength, 0.5 * field.penaltyAreaWidth, direction);
  }
  compare();
  ASSERT_EQ(errors.quantities.at("direction").amounts.count(), 2U);
  EXPECT_NEAR(errors.quantities.at("direction").amounts.maximum(), 0, 1e-6);
}

TEST_F(LineComparisonTest, edgesInTheImageWithoutAPointAreMissed) {
  compare();
  EXPECT_GT(errors.there, 10U);
  EXPECT_EQ(errors.missed, errors.there);
  const std::size_t there = errors.there;
  errors = {};
  for (double y = -0.6; y < 0.65; y += 0.1) {
    addPoint(0.9, y);
    addPoint(1.1, y);
  }
  compare();
  EXPECT_EQ(errors.there, there);
  EXPECT_EQ(errors.missed, 0U);
}

TEST_F(LineComparisonTest, segmentsHaveCountsOfTheirOwn) {
  addSegment({0.9, -0.7}, {0.9, 0});
  addSegment({0.9, 0}, {0.4, 0});
  compare();
  const ErrorQuantity& segments = errors.quantities.at("segments");
  EXPECT_EQ(segments.own.reported, 2U);
  EXPECT_EQ(segments.own.invented, 1U) << "one leaves the line";
  EXPECT_NEAR(segments.amounts.mean(), 0, 1e-6);
  EXPECT_GT(segments.own.missed, 0U);
  EXPECT_LT(segments.own.missed, segments.own.there);
  EXPECT_EQ(&errors.countsOf(segments), &segments.own);
}

TEST_F(LineComparisonTest, segmentsAreAlsoMissedBeforeTheFirstOne) {
  compare();
  compare();
  EXPECT_FALSE(errors.quantities.contains("segments")) << "perhaps it never finds any";
  addSegment({0.9, -0.7}, {0.9, 0.7});
  compare();
  const ErrorCounts& counts = errors.quantities.at("segments").own;
  EXPECT_EQ(counts.there, errors.there);
  EXPECT_GE(counts.missed, 2 * counts.there / 3);
  EXPECT_LT(counts.missed, counts.there);
}

}  // namespace
}  // namespace robotlink
