// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/drawing/Drawings.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/packages/Conversions.h"

using namespace robotlink;
using namespace std::chrono_literals;
using foxglove::LinePrimitive;
using foxglove::PointsAnnotation;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct ImageDrawingTest : testing::Test {
  foxglove::ImageAnnotations message;
  ImageDrawing drawing{message, Instant(2s)};
};

struct SceneDrawingTest : testing::Test {
  foxglove::SceneEntity message;
  SceneDrawing drawing{message};
};

}  // namespace

TEST_F(ImageDrawingTest, aCircleHasItsDiameterColorWidthFillAndTime) {
  drawing.circle({10, 20}, 5, {{255, 0, 51}, 0.5}, 2, {{0, 255, 0}, 0.25});
  const auto& circle = message.circles(0);
  EXPECT_EQ(vector2(circle.position()), Vector2(10, 20));
  EXPECT_EQ(circle.diameter(), 10);
  EXPECT_EQ(circle.thickness(), 2);
  EXPECT_EQ(circle.outline_color().r(), 1);
  EXPECT_EQ(circle.outline_color().b(), 0.2);
  EXPECT_EQ(circle.outline_color().a(), 0.5);
  EXPECT_EQ(circle.fill_color().a(), 0.25);
  EXPECT_EQ(instant(circle.timestamp()), Instant(2s));
  drawing.circle({10, 20}, 5, colors::kRed);
  EXPECT_FALSE(message.circles(1).has_fill_color());
}

TEST_F(ImageDrawingTest, linesOfOneColorAndWidthAreOneAnnotation) {
  for (int i = 0; i < 1000; ++i) drawing.line({0.0, 1.0 * i}, {10, 1.0 * i}, colors::kRed);
  ASSERT_EQ(message.points_size(), 1);
  EXPECT_EQ(message.points(0).type(), PointsAnnotation::LINE_LIST);
  EXPECT_EQ(message.points(0).points_size(), 2000);
  drawing.line({0, 0}, {1, 1}, colors::kBlue);
  drawing.line({0, 0}, {1, 1}, colors::kBlue, 3);
  EXPECT_EQ(message.points_size(), 3);
}

TEST_F(SceneDrawingTest, aThousandDartsAreOnePrimitiveAndPointAhead) {
  const Pose2 pose{1, 2, kPi / 2};
  drawing.dart(pose, colors::kBlue, 0.4);
  ASSERT_EQ(message.triangles_size(), 1);
  const auto& triangle = message.triangles(0);
  EXPECT_NEAR(triangle.points(0).x(), 1, 1e-12);
  EXPECT_NEAR(triangle.points(0).y(), 2.4, 1e-12);
  EXPECT_NEAR(triangle.points(1).x(), 0.9, 1e-12);
  EXPECT_NEAR(triangle.points(2).x(), 1.1, 1e-12);
  drawing.dart({kNan, 2, 0}, colors::kBlue);
  EXPECT_EQ(triangle.points_size(), 3);
  foxglove::SceneEntity poses;
  SceneDrawing other(poses);
  for (int i = 1; i < 1000; ++i) drawing.dart(pose, colors::kBlue);
  for (int i = 0; i < 1000; ++i) other.pose(pose, colors::kBlue);
  EXPECT_EQ(message.triangles_size(), 1);
  EXPECT_LT(10 * message.ByteSizeLong(), poses.ByteSizeLong());
}

TEST_F(ImageDrawingTest, anArrowIsThreeLinesThatEndAtItsTip) {
  drawing.arrow({0, 0}, {30, 0}, colors::kRed);
  ASSERT_EQ(message.points_size(), 1);
  const auto& points = message.points(0).points();
  ASSERT_EQ(points.size(), 6);
  for (const int tip : {1, 2, 4}) EXPECT_EQ(vector2(points[tip]), Vector2(30, 0));
  EXPECT_LT(points[3].x(), 30);
}

TEST_F(ImageDrawingTest, loopsAreClosedByTheirType) {
  const std::array<Vector2, 3> corners{Vector2(0, 0), Vector2(5, 0), Vector2(0, 5)};
  drawing.polygon(corners, colors::kRed, 1, {colors::kBlue.rgb, 1});
  drawing.rectangle({1, 2}, {3, 4}, colors::kRed);
  drawing.ellipse({0, 0}, {4, 2}, 0, colors::kRed);
  ASSERT_EQ(message.points_size(), 3);
  for (const auto& loop : message.points()) EXPECT_EQ(loop.type(), PointsAnnotation::LINE_LOOP);
  EXPECT_EQ(message.points(0).fill_color().b(), 230 / 255.0);
  EXPECT_EQ(message.points(1).points_size(), 4);
  EXPECT_EQ(vector2(message.points(1).points(1)), Vector2(3, 2));
  EXPECT_EQ(message.points(2).points_size(), 32);
}

TEST_F(ImageDrawingTest, dotsAndTextsHaveTheirSizes) {
  drawing.dot({1, 2}, colors::kRed, 5);
  drawing.dot({3, 4}, colors::kRed, 5);
  drawing.text({7, 8}, "ball", colors::kWhite, 12);
  ASSERT_EQ(message.points_size(), 1);
  EXPECT_EQ(message.points(0).type(), PointsAnnotation::POINTS);
  EXPECT_EQ(message.points(0).thickness(), 5);
  EXPECT_EQ(message.points(0).points_size(), 2);
  EXPECT_EQ(message.texts(0).text(), "ball");
  EXPECT_EQ(message.texts(0).font_size(), 12);
  EXPECT_EQ(message.texts(0).text_color().r(), 1);
}

TEST_F(ImageDrawingTest, whatIsNotFiniteIsLeftOut) {
  const std::array<Vector2, 2> corners{Vector2(0, 0), Vector2(kNan, 0)};
  drawing.line({0, 0}, {kNan, 1}, colors::kRed);
  drawing.arrow({0, 0}, {kNan, 1}, colors::kRed);
  drawing.circle({0, 0}, std::numeric_limits<double>::infinity(), colors::kRed);
  drawing.ellipse({0, 0}, {1, kNan}, 0, colors::kRed);
  drawing.polygon(corners, colors::kRed);
  drawing.dot({kNan, 1}, colors::kRed);
  drawing.text({kNan, 1}, "x", colors::kRed);
  EXPECT_EQ(message.ByteSizeLong(), 0U);
}

TEST_F(SceneDrawingTest, flatShapesLieJustAboveTheGroundWithWidthsInPixels) {
  drawing.line(Vector2(1, 2), Vector2(3, 4), colors::kRed, 2);
  drawing.circle({0, 0}, 0.5, colors::kRed);
  ASSERT_EQ(message.lines_size(), 2);
  for (const auto& line : message.lines()) {
    EXPECT_TRUE(line.scale_invariant());
    EXPECT_EQ(line.pose().orientation().w(), 1);
    for (const auto& point : line.points()) EXPECT_EQ(point.z(), SceneDrawing::kGroundHeight);
  }
  EXPECT_EQ(message.lines(0).thickness(), 2);
  EXPECT_EQ(message.lines(1).type(), LinePrimitive::LINE_LOOP);
  EXPECT_EQ(message.lines(1).points_size(), 32);
  EXPECT_EQ(message.triangles_size(), 0);
}

TEST_F(SceneDrawingTest, linesOfOneColorAndWidthAreOnePrimitive) {
  for (int i = 0; i < 100; ++i) drawing.line(Vector3(0, 0, i), Vector3(1, 0, i), colors::kRed);
  drawing.arrow({0, 0}, {1, 0}, colors::kRed);
  ASSERT_EQ(message.lines_size(), 1);
  EXPECT_EQ(message.lines(0).points_size(), 206);
}

TEST_F(SceneDrawingTest, fillsAreTrianglesWhoseIndicesFit) {
  const std::array<Vector2, 4> corners{Vector2(0, 0), Vector2(4, 0), Vector2(1, 1), Vector2(0, 4)};
  drawing.polygon(corners, colors::kRed, 1, colors::kBlue);
  drawing.circle({5, 5}, 1, colors::kRed, 1, colors::kBlue);
  for (int i = 0; i < 10; ++i) drawing.dot({1.0 * i, 0}, colors::kBlue);
  ASSERT_EQ(message.triangles_size(), 1);
  const auto& triangles = message.triangles(0);
  EXPECT_EQ(triangles.points_size(), 4 + 32 + 10 * 8);
  EXPECT_EQ(triangles.indices_size(), 3 * (2 + 30 + 10 * 6));
  for (const auto index : triangles.indices()) EXPECT_LT(static_cast<int>(index), triangles.points_size());
}

TEST_F(SceneDrawingTest, aPosePointsWhereItHeads) {
  drawing.pose({1, 2, kPi / 2}, colors::kRed, 0.4);
  ASSERT_EQ(message.lines_size(), 2);
  const auto& tip = message.lines(1).points(1);
  EXPECT_NEAR(tip.x(), 1, 1e-9);
  EXPECT_NEAR(tip.y(), 2.4, 1e-9);
}

TEST_F(SceneDrawingTest, bodiesHaveTheirPosesAndSizes) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = Vector3(1, 2, 3);
  drawing.sphere({4, 5, 6}, 0.5, colors::kRed);
  drawing.box(pose, {0.1, 0.2, 0.3}, colors::kRed);
  drawing.axes(pose, 0.5);
  drawing.text({1, 1}, "here", colors::kWhite);
  EXPECT_EQ(vector3(message.spheres(0).size()), Vector3(1, 1, 1));
  EXPECT_EQ(vector3(message.spheres(0).pose().position()), Vector3(4, 5, 6));
  EXPECT_EQ(vector3(message.cubes(0).size()), Vector3(0.1, 0.2, 0.3));
  ASSERT_EQ(message.arrows_size(), 3);
  for (int axis = 0; axis < 3; ++axis) {
    const Pose3 arrow = pose3(message.arrows(axis).pose());
    EXPECT_TRUE((arrow.linear() * Vector3::UnitX()).isApprox(Vector3::Unit(axis), 1e-9)) << axis;
    EXPECT_NEAR(message.arrows(axis).shaft_length() + message.arrows(axis).head_length(), 0.5, 1e-9);
  }
  EXPECT_TRUE(message.texts(0).billboard());
  EXPECT_TRUE(message.texts(0).scale_invariant());
}

TEST_F(SceneDrawingTest, whatIsNotFiniteIsLeftOut) {
  Pose3 pose = Pose3::Identity();
  pose.translation().x() = kNan;
  drawing.line(Vector2(kNan, 0), Vector2(1, 1), colors::kRed);
  drawing.line(Vector3(0, 0, kNan), Vector3(1, 1, 1), colors::kRed);
  drawing.circle({0, 0}, kNan, colors::kRed, 1, colors::kBlue);
  drawing.dot({0, 0}, colors::kRed, kNan);
  drawing.pose({kNan, 0, 0}, colors::kRed);
  drawing.pose({0, 0, kNan}, colors::kRed);
  drawing.sphere({0, 0, 0}, kNan, colors::kRed);
  drawing.box(pose, {1, 1, 1}, colors::kRed);
  drawing.axes(pose, 1);
  EXPECT_EQ(message.ByteSizeLong(), 0U);
}
