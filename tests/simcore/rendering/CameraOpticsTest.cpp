// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/CameraOptics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace simcore {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;

constexpr int kColumns = 64, kRows = 48;

CameraModel cameraModel(const LensDistortion& lens = {}) {
  CameraModel camera;
  camera.width = kColumns;
  camera.height = kRows;
  camera.horizontalAngle = 1.2;
  camera.verticalAngle = 2 * std::atan(std::tan(0.6) * kRows / kColumns);
  camera.distortion = lens;
  return camera;
}

/// A white bar, 0.4 m wide and 4 m high, 2 m before the camera, on body 1 before a black background.
std::shared_ptr<const RenderScene> barScene() {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world", "bar"};
  scene->meshes = {boxMesh({0.01F, 0.4F, 4})};
  scene->instances = {{0, 1, Pose3::Identity(), {200, 200, 200}, "bar", true}};
  scene->ambient = 1;
  return scene;
}

/// Takes an image of the bar, which moves to the right by `speed`.
Image imageOf(const CameraModel& camera, const ShutterModel& shutter, double speed) {
  CameraRenderer renderer(barScene(), {});
  CameraOptics optics;
  const auto posesAt = [&](double age, std::vector<Pose3>& poses) {
    poses.assign(2, Pose3::Identity());
    poses[1].translation() = Eigen::Vector3d(2, speed * age, 0);
  };
  Image image;
  optics.render(renderer, posesAt, {}, camera, shutter, PixelFormat::kRgb8, {}, image);
  return image;
}

int red(const Image& image, int x, int y) {
  return image.data[static_cast<std::size_t>((y * image.width + x) * 3)];
}

/// The middle of what is bright in a row, and the sum of its brightness.
std::pair<double, double> middleOf(const Image& image, int y) {
  double sum = 0, moment = 0;
  for (int x = 0; x < image.width; ++x) {
    sum += red(image, x, y);
    moment += red(image, x, y) * (x + 0.5);
  }
  return {sum > 0 ? moment / sum : 0, sum};
}

double focalLength() {
  return kColumns / 2.0 / std::tan(0.6);
}

TEST(CameraOpticsTest, undistortingIsTheReverseOfDistorting) {
  const LensDistortion lens{-0.2, 0.05, -0.01, 0.003, -0.002};
  for (double x = -0.6; x <= 0.6; x += 0.2) {
    for (double y = -0.4; y <= 0.4; y += 0.2) {
      const Eigen::Vector2d point(x, y);
      EXPECT_LT((CameraOptics::undistorted(lens, CameraOptics::distorted(lens, point)) - point).norm(), 1e-9);
    }
  }
  // Computed by hand: r^2 = 0.25.
  const Eigen::Vector2d seen = CameraOptics::distorted({0.4, 0, 0, 0.1, 0}, {0.3, 0.4});
  EXPECT_NEAR(seen.x(), 0.3 * 1.1 + 2 * 0.1 * 0.3 * 0.4, 1e-12);
  EXPECT_NEAR(seen.y(), 0.4 * 1.1 + 0.1 * (0.25 + 2 * 0.16), 1e-12);
}

TEST(CameraOpticsTest, aLensWithoutErrorsGivesTheSameBytes) {
  CameraRenderer renderer(barScene(), {});
  const std::vector<Pose3> poses{Pose3::Identity(), Pose3(Eigen::Translation3d(2, 0, 0))};
  renderer.setPoses(poses);
  Image direct;
  renderer.render(Pose3::Identity(), cameraModel(), PixelFormat::kRgb8, {}, direct);
  EXPECT_EQ(imageOf(cameraModel(), {}, 0).data, direct.data);
}

TEST(CameraOpticsTest, aBarrelBendsLinesAsItsFormulaSays) {
  const LensDistortion lens{-0.3, 0, 0, 0, 0};
  CameraRenderer renderer(barScene(), {});
  CameraOptics optics;
  const auto posesAt = [](double, std::vector<Pose3>& poses) {
    poses.assign(2, Pose3::Identity());
    poses[1].translation() = Eigen::Vector3d(2, -0.9, 0);
  };
  Image image;
  optics.render(renderer, posesAt, {}, cameraModel(lens), {}, PixelFormat::kRgb8, {}, image);
  for (const int y : {4, kRows / 2, kRows - 5}) {
    // The point of the bar's near face that appears in the middle of the row, found by trying.
    const double wanted = (y + 0.5 - kRows / 2.0) / focalLength();
    Eigen::Vector2d best(0, 10);
    for (double v = -1; v <= 1; v += 1e-4) {
      const Eigen::Vector2d seen = CameraOptics::distorted(lens, {0.9 / 1.995, v});
      if (std::abs(seen.y() - wanted) < std::abs(best.y() - wanted)) best = seen;
    }
    EXPECT_NEAR(middleOf(image, y).first, best.x() * focalLength() + kColumns / 2.0, 0.7) << y;
  }
}

TEST(CameraOpticsTest, whatALensCannotShowIsBlack) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes = {boxMesh({0.1F, 100, 100})};
  scene->instances = {{0, 0, Pose3(Eigen::Translation3d(2, 0, 0)), {200, 200, 200}, "wall", true}};
  scene->ambient = 1;
  CameraRenderer renderer(scene, {});
  CameraOptics optics;
  Image image;
  optics.render(
      renderer, [](double, std::vector<Pose3>& poses) { poses.assign(1, Pose3::Identity()); }, {},
      cameraModel({-1, 0, 0, 0, 0}), {}, PixelFormat::kRgb8, {}, image);
  // r (1 - r^2) is at most 0.385, and then turns back.
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) {
      const double seen = std::hypot(x + 0.5 - kColumns / 2.0, y + 0.5 - kRows / 2.0) / focalLength();
      if (seen > 0.39) {
        EXPECT_EQ(red(image, x, y), 0) << x << " " << y;
      } else if (seen < 0.37) {
        EXPECT_GT(red(image, x, y), 150) << x << " " << y;
      }
    }
  }
}

TEST(CameraOpticsTest, whatMovesDuringTheExposureIsBlurred) {
  const double speed = 16, exposure = 0.05;
  const Image sharp = imageOf(cameraModel(), {}, speed),
              blurred = imageOf(cameraModel(), {exposure, 0}, speed);
  const auto [sharpMiddle, sharpSum] = middleOf(sharp, kRows / 2);
  const auto [middle, sum] = middleOf(blurred, kRows / 2);
  // It was to the left on average, at half of the exposure; its light is spread, not lost.
  EXPECT_NEAR(sharpMiddle - middle, speed * exposure / 2 / 1.995 * focalLength(), 0.6);
  EXPECT_NEAR(sum, sharpSum, 0.1 * sharpSum);
  int brightest = 0;
  for (int x = 0; x < kColumns; ++x) brightest = std::max(brightest, red(blurred, x, kRows / 2));
  EXPECT_LT(brightest, 120);
  EXPECT_EQ(imageOf(cameraModel(), {exposure, 0}, 0).data, sharp.data) << "what stands stays sharp";
}

TEST(CameraOpticsTest, aRollingShutterShowsUpperRowsEarlier) {
  const double speed = 8, readout = 0.04;
  const Image image = imageOf(cameraModel(), {0, readout}, speed);
  const double top = middleOf(image, 2).first, bottom = middleOf(image, kRows - 3).first;
  const double rows = (kRows - 5.0) / (kRows - 1);
  EXPECT_NEAR(bottom - top, speed * readout * rows / 1.995 * focalLength(), 1.2);
  EXPECT_NEAR(bottom, middleOf(imageOf(cameraModel(), {}, speed), kRows - 3).first, 1);
}

TEST(CameraOpticsTest, facesOfRoundShapesAreFlatIfWanted) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes = {sphereMesh(0.5F)};
  scene->instances = {{0, 0, Pose3(Eigen::Translation3d(2, 0, 0)), {200, 200, 200}, "ball", true}};
  scene->lamps = {{{0, 0, 3}, 1, 0}};
  scene->ambient = 0;
  const auto colorsOf = [&](bool flat) {
    CameraRenderer renderer(scene, {.shadows = false, .flat = flat});
    Image image;
    renderer.render(Pose3::Identity(), cameraModel(), PixelFormat::kRgb8, {}, image);
    int changes = 0;
    for (int x = 1; x < kColumns; ++x)
      changes += red(image, x, kRows / 2 - 3) != red(image, x - 1, kRows / 2 - 3);
    return changes;
  };
  EXPECT_LT(colorsOf(true), colorsOf(false));
}

TEST(CameraOpticsTest, severalLampsCastShadowsOfTheirOwn) {
  // A post between two lamps on a floor: each side of it has the light of one lamp.
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes = {boxMesh({4, 4, 0.1F}), boxMesh({0.2F, 2, 1})};
  scene->instances = {{0, 0, Pose3(Eigen::Translation3d(0, 0, -0.05)), {200, 200, 200}, "floor", true},
                      {1, 0, Pose3(Eigen::Translation3d(0, 0, 0.5)), {200, 200, 200}, "post", true}};
  scene->ambient = 0;
  const auto floorLight = [&](std::vector<Lamp> lamps) {
    auto lit = std::make_shared<RenderScene>(*scene);
    lit->lamps = std::move(lamps);
    CameraRenderer renderer(lit, {});
    const Pose3 above = Eigen::Translation3d(0.6, 0, 3) *
                        Pose3(Eigen::AngleAxisd(robotlink::kPi / 2, Eigen::Vector3d::UnitY()));
    Image image;
    renderer.render(above, cameraModel(), PixelFormat::kRgb8, {}, image);
    return red(image, kColumns / 2, kRows / 2);
  };
  const Lamp left{{-2, 0, 1}, 0.4F, 0}, right{{2, 0, 1}, 0.4F, 0};
  EXPECT_EQ(floorLight({left}), 0) << "in the shadow of the post";
  EXPECT_GT(floorLight({right}), 20);
  EXPECT_EQ(floorLight({left, right}), floorLight({right}));
}

}  // namespace
}  // namespace simcore
