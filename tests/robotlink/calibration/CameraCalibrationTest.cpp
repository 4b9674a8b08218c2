// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/calibration/CameraCalibration.h"

#include <gmock/gmock.h>

#include "tests/robotlink/calibration/BoardPicture.h"

namespace robotlink::test {
namespace {

const LensModel kLens{320, 240, 300, 302, 158, 123};

std::vector<std::vector<Vector2>> foundInAll(const Chessboard& board) {
  std::vector<std::vector<Vector2>> views;
  for (const Pose3& pose : boardPoses()) {
    const auto found = findChessboard(boardPicture(board, pose, kLens).view(), board);
    if (found && *found) views.push_back(**found);
  }
  return views;
}

TEST(CameraCalibrationTest, theCornersOfABoardAreFoundToAFifthOfAPixel) {
  const Chessboard board;
  const Pose3 camera = boardPoses().front();
  const auto found = findChessboard(boardPicture(board, camera, kLens).view(), board);
  ASSERT_TRUE(found && *found);
  const auto corners = board.corners();
  ASSERT_EQ((*found)->size(), corners.size());
  // The order may begin at any end of the board, which looks alike from there.
  for (const Vector3& corner : corners) {
    const Vector2 expected = pixelOf(corner, camera, kLens);
    EXPECT_TRUE(std::ranges::any_of(**found, [&](const Vector2& one) {
      return (one - expected).norm() < 0.2;
    })) << corner.transpose();
  }
}

TEST(CameraCalibrationTest, withoutTheWholeBoardNothingIsFound) {
  const Image gray(320, 240, PixelFormat::kYuyv);
  const auto found = findChessboard(gray.view(), {});
  ASSERT_TRUE(found);
  EXPECT_FALSE(*found);
  EXPECT_EQ(findChessboard(gray.view(), {7, 7, 0.02}).error().id, "calibration.points");
  EXPECT_EQ(findChessboard({}, {}).error().id, "calibration.points");
}

TEST(CameraCalibrationTest, aLensIsComputedFromItsPictures) {
  const Chessboard board;
  const auto views = foundInAll(board);
  ASSERT_GE(views.size(), 5U);
  const auto fit = fitLens(views, board, kLens.width, kLens.height);
  ASSERT_TRUE(fit) << fit.error().text;
  EXPECT_LT(fit->error, 0.1);
  EXPECT_EQ(fit->viewErrors.size(), views.size());
  EXPECT_NEAR(fit->lens.focalX, kLens.focalX, 3);
  EXPECT_NEAR(fit->lens.focalY, kLens.focalY, 3);
  EXPECT_NEAR(fit->lens.centerX, kLens.centerX, 2);
  EXPECT_NEAR(fit->lens.centerY, kLens.centerY, 2);
  EXPECT_NEAR(fit->lens.horizontalAngle(), 2 * std::atan(160 / kLens.focalX), 0.01);
}

TEST(CameraCalibrationTest, fewOrWrongViewsAreRefused) {
  const Chessboard board;
  const std::vector<std::vector<Vector2>> two(2, std::vector<Vector2>(54, Vector2::Zero()));
  EXPECT_EQ(fitLens(two, board, 320, 240).error().id, "calibration.points");
  const std::vector<std::vector<Vector2>> others(3, std::vector<Vector2>(10, Vector2::Zero()));
  EXPECT_EQ(fitLens(others, board, 320, 240).error().id, "calibration.points");
  const std::vector<std::vector<Vector2>> same(3, std::vector<Vector2>(54, Vector2(1, 1)));
  EXPECT_FALSE(fitLens(same, board, 320, 240));
}

TEST(CameraCalibrationTest, aPlaceIsComputedFromKnownPoints) {
  const Pose3 camera = cameraAt({-1, 0.4, 1.2}, 0.3, 0.5, -0.1);
  std::vector<Vector3> points;
  std::vector<Vector2> pixels;
  for (const double x : {0.5, 1.5, 2.5})
    for (const double y : {-0.5, 0.6}) {
      points.emplace_back(x, y, 0);
      pixels.push_back(pixelOf(points.back(), camera, kLens));
    }
  const auto fit = fitPlace(points, pixels, kLens);
  ASSERT_TRUE(fit) << fit.error().text;
  EXPECT_NEAR(fit->height(), 1.2, 1e-3);
  EXPECT_NEAR(fit->tilt(), 0.5, 1e-3);
  EXPECT_NEAR(fit->roll(), -0.1, 1e-3);
  EXPECT_NEAR(fit->pan(), 0.3, 1e-3);
  EXPECT_NEAR(fit->cameraInWorld.translation().x(), -1, 1e-3);
  EXPECT_LT(fit->error, 0.01);
  // A mark that was mistaken for another one has the largest error.
  pixels[2] += Vector2(20, 0);
  const auto wrong = fitPlace(points, pixels, kLens);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(std::ranges::max_element(wrong->errors) - wrong->errors.begin(), 2);
  points.resize(3);
  pixels.resize(3);
  EXPECT_EQ(fitPlace(points, pixels, kLens).error().id, "calibration.points");
}

TEST(CameraCalibrationTest, aBoardOnTheGroundTellsHeightTiltAndRoll) {
  const Chessboard board;
  const Pose3 camera = boardPoses()[1];
  auto found = findChessboard(boardPicture(board, camera, kLens).view(), board);
  ASSERT_TRUE(found && *found);
  for (int order = 0; order < 2; ++order) {
    const auto fit = fitPlaceAboveBoard(**found, board, kLens);
    ASSERT_TRUE(fit) << fit.error().text;
    EXPECT_NEAR(fit->height(), camera.translation().z(), 0.003);
    EXPECT_NEAR(fit->tilt(), 1.1, 0.01);
    EXPECT_NEAR(fit->roll(), 0, 0.01);
    // The other way round it is the same board.
    std::ranges::reverse(**found);
  }
}

TEST(CameraModelTest, anglesAndFocalLengthsBelongTogether) {
  const LensModel lens = LensModel::fromAngle(640, 480, 1.0);
  EXPECT_NEAR(lens.horizontalAngle(), 1.0, 1e-12);
  EXPECT_NEAR(lens.verticalAngle(), 2 * std::atan(0.75 * std::tan(0.5)), 1e-12);
  EXPECT_EQ(lens.centerX, 320);
  EXPECT_EQ((Chessboard{3, 4, 0.5}).corners().back(), Vector3(1, 1.5, 0));
  EXPECT_FALSE((Chessboard{2, 4, 0.5}).isUsable());
  EXPECT_FALSE((Chessboard{5, 4, 0}).isUsable());
}

}  // namespace
}  // namespace robotlink::test
