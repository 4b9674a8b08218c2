// SPDX-License-Identifier: GPL-3.0-or-later
// Directional lights and spots in camera images.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/rendering/CameraRenderer.h"
#include "tests/simcore/CameraScenes.h"

namespace simcore {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// A gray floor, and a plate of 1 m 1 m above its center, seen from 8 m above the floor.
class LampKinds : public testing::Test {
 protected:
  robotlink::Image seenUnder(const Lamp& lamp, bool withPlate) {
    return seenUnder(std::vector<Lamp>{lamp}, withPlate, robotlink::PixelFormat::kRgb8);
  }
  robotlink::Image seenUnder(const std::vector<Lamp>& lamps, bool withPlate, robotlink::PixelFormat format) {
    auto scene = std::make_shared<RenderScene>();
    scene->meshes = {boxMesh({20, 20, 0.1F}), boxMesh({1, 1, 0.1F})};
    scene->instances.push_back(
        {0, 0, Pose3(Eigen::Translation3d(0, 0, -0.05)), {200, 200, 200}, "floor", true});
    if (withPlate)
      scene->instances.push_back(
          {1, 0, Pose3(Eigen::Translation3d(0, 0, 1)), {200, 200, 200}, "plate", true});
    scene->bodies = {"world"};
    scene->ambient = 0.2F;
    scene->lamps = lamps;
    CameraRenderer renderer(scene, {true});
    renderer.setPoses(std::vector<Pose3>{Pose3::Identity()});
    robotlink::Image image;
    CameraModel camera;
    camera.width = kWidth;
    camera.height = kHeight;
    renderer.render(camera_, camera, format, {}, image);
    return image;
  }
  /// The red channel at a point of the floor.
  int at(const robotlink::Image& image, double x, double y) const { return colorAt(image, x, y).r; }
  robotlink::Rgb colorAt(const robotlink::Image& image, double x, double y) const {
    const auto [column, row] = placeOf(x, y);
    return test::pixel(image, column, row);
  }
  /// The pixel that shows a point of the floor.
  std::pair<int, int> placeOf(double x, double y) const {
    const Eigen::Vector3d inCamera = camera_.inverse() * Eigen::Vector3d(x, y, 0);
    const CameraModel camera;
    const double focalX = kWidth / 2.0 / std::tan(camera.horizontalAngle / 2);
    const double focalY = kHeight / 2.0 / std::tan(camera.verticalAngle / 2);
    return {static_cast<int>(kWidth / 2.0 - focalX * inCamera.y() / inCamera.x()),
            static_cast<int>(kHeight / 2.0 - focalY * inCamera.z() / inCamera.x())};
  }
  static Lamp lamp(Lamp::Kind kind, const Eigen::Vector3f& direction) {
    Lamp result;
    result.kind = kind;
    result.direction = direction.normalized();
    result.position = {0, 0, 6};
    result.intensity = 0.5F;
    return result;
  }

  const Pose3 camera_ = test::lookAt({-1, 0, 8}, {0, 0, 0});
};

TEST_F(LampKinds, aDirectionalLightIsEqualEverywhere) {
  const auto image = seenUnder(lamp(Lamp::Kind::kDirectional, {0, 0, -1}), false);
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 1.0}, {-1.5, -2.0}, {0.5, 2.5}})
    EXPECT_NEAR(at(image, x, y), 200 * 0.7, 1) << x << " " << y;
}

TEST_F(LampKinds, aDirectionalLightFallsWithItsSlope) {
  const auto image = seenUnder(lamp(Lamp::Kind::kDirectional, {1, 0, -1}), false);
  EXPECT_NEAR(at(image, 0, 0), 200 * (0.2 + 0.5 * std::sqrt(0.5)), 1);
  const auto below = seenUnder(lamp(Lamp::Kind::kDirectional, {0, 0, 1}), false);
  EXPECT_NEAR(at(below, 0, 0), 200 * 0.2, 1);
}

TEST_F(LampKinds, aDirectionalLightHasParallelShadows) {
  // The plate's shadow is as large as the plate and 1 m to the right of it, as the light falls at 45 degrees.
  const auto image = seenUnder(lamp(Lamp::Kind::kDirectional, {0, -1, -1}), true);
  const int lit = static_cast<int>(std::lround(200 * (0.2 + 0.5 * std::sqrt(0.5))));
  EXPECT_NEAR(at(image, 0.3, -1), 40, 1);
  EXPECT_NEAR(at(image, 0.3, -0.65), 40, 1);
  EXPECT_NEAR(at(image, 0.3, -1.35), 40, 1);
  EXPECT_NEAR(at(image, 0.3, -1.8), lit, 1);
  EXPECT_NEAR(at(image, -0.8, -1), lit, 1);
}

TEST_F(LampKinds, aSpotLightsItsConeOnly) {
  Lamp spot = lamp(Lamp::Kind::kSpot, {0, 0, -1});
  // Radii of 1.0 m and 1.6 m on the floor.
  spot.innerAngle = 2 * std::atan(1.0F / 6);
  spot.outerAngle = 2 * std::atan(1.6F / 6);
  const auto image = seenUnder(spot, false);
  EXPECT_NEAR(at(image, 0, 0), 140, 1);
  EXPECT_NEAR(at(image, 0, 0.9), 200 * (0.2 + 0.5 * 6 / std::hypot(6, 0.9)), 2);
  EXPECT_NEAR(at(image, 0, 1.8), 40, 1);
  EXPECT_NEAR(at(image, 0, -1.8), 40, 1);
  const int between = at(image, 0, 1.3);
  EXPECT_GT(between, 60);
  EXPECT_LT(between, 130);
}

TEST_F(LampKinds, aSpotHasShadows) {
  Lamp spot = lamp(Lamp::Kind::kSpot, {0, 0, -1});
  spot.innerAngle = spot.outerAngle = 2 * std::atan(2.0F / 6);
  const auto image = seenUnder(spot, true);
  // The plate's edge at 0.5 m throws its shadow to 0.6 m; on this side the camera sees below it.
  EXPECT_NEAR(at(image, -0.58, 0), 40, 1);
  EXPECT_GT(at(image, -0.8, 0), 130);
}

TEST_F(LampKinds, aColoredLampGivesThingsItsColor) {
  Lamp sun = lamp(Lamp::Kind::kDirectional, {0, -1, -1});
  sun.color = {1, 0.5F, 0};
  const auto image = seenUnder(sun, true);
  // The ambient light is white, and alone in the shadow of the plate.
  const robotlink::Rgb lit = colorAt(image, 0.3, -1.8), shaded = colorAt(image, 0.3, -1);
  EXPECT_NEAR(lit.r, 200 * (0.2 + 0.5 * std::sqrt(0.5)), 1);
  EXPECT_NEAR(lit.g, 200 * (0.2 + 0.25 * std::sqrt(0.5)), 1);
  EXPECT_NEAR(lit.b, 200 * 0.2, 1);
  for (const int channel : {shaded.r, shaded.g, shaded.b}) EXPECT_NEAR(channel, 40, 1);
}

TEST_F(LampKinds, lampsOfSeveralColorsAddUp) {
  Lamp red = lamp(Lamp::Kind::kDirectional, {0, 0, -1}), blue = red, white = red;
  red.color = {1, 0, 0};
  red.intensity = 0.3F;
  blue.color = {0, 0, 0.5F};
  white.intensity = 0.1F;
  const auto image = seenUnder({white, red, blue, red}, false, robotlink::PixelFormat::kRgb8);
  const robotlink::Rgb seen = colorAt(image, 1, 1);
  EXPECT_NEAR(seen.r, 200 * (0.2 + 0.1 + 0.6), 1);
  EXPECT_NEAR(seen.g, 200 * (0.2 + 0.1), 1);
  EXPECT_NEAR(seen.b, 200 * (0.2 + 0.1 + 0.25), 1);
  // An image in YCbCr has the same color.
  const auto yuyv = seenUnder({white, red, blue, red}, false, robotlink::PixelFormat::kYuyv);
  const auto [column, row] = placeOf(1, 1);
  const std::uint8_t* const pair = yuyv.row(row) + column / 2 * 4;
  const robotlink::YCbCr expected = robotlink::toYCbCr(seen);
  EXPECT_NEAR(pair[column % 2 * 2], expected.y, 1);
  EXPECT_NEAR(pair[1], expected.cb, 1);
  EXPECT_NEAR(pair[3], expected.cr, 1);
}

TEST_F(LampKinds, tooMuchColoredLightKeepsItsHue) {
  Lamp sun = lamp(Lamp::Kind::kDirectional, {0, 0, -1});
  sun.color = {1, 0.5F, 0.5F};
  sun.intensity = 1.8F;
  const robotlink::Rgb seen = colorAt(seenUnder(sun, false), 0, 0);
  EXPECT_NEAR(seen.r, 200, 1);
  EXPECT_NEAR(seen.g, 200 * (0.2 + 0.9) / 2, 1);
  EXPECT_NEAR(seen.b, 200 * (0.2 + 0.9) / 2, 1);
}

TEST_F(LampKinds, grayLampsAreOnlyDimmer) {
  Lamp gray = lamp(Lamp::Kind::kPoint, {0, 0, -1}), dim = gray;
  gray.color = {0.5F, 0.5F, 0.5F};
  dim.intensity = 0.25F;
  EXPECT_EQ(seenUnder(gray, true), seenUnder(dim, true));
}

}  // namespace
}  // namespace simcore
