// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/rendering/CameraRenderer.h"
#include "tests/simcore/CameraScenes.h"

using namespace simcore;
using namespace simcore::test;
using robotlink::Image;
using robotlink::PixelFormat;

// What a camera truly sees beside what it shows of it, and what light and lens do to that.
namespace {

using Arithmetic = CameraRenderer::Arithmetic;

constexpr std::uint8_t kNothing = 251;
constexpr Rgb kNobody{255, 255, 255};

std::vector<std::uint8_t> numbersOf(const RenderScene& scene) {
  std::vector<std::uint8_t> numbers;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    numbers.push_back(static_cast<std::uint8_t>(i % kNothing));
  return numbers;
}

/// The same bodies, each in a color of its own that no light changes.
CameraScene glowing(const CameraScene& from) {
  auto scene = std::make_shared<RenderScene>(*from.scene);
  for (std::size_t i = 0; i < scene->instances.size(); ++i) {
    scene->instances[i].color = {static_cast<std::uint8_t>(i & 255), static_cast<std::uint8_t>(i >> 8), 0};
  }
  scene->lamps.clear();
  scene->ambient = 1;
  scene->background = kNobody;
  return {scene, from.poses, from.cameras};
}

/// A wall that fills the image, in even light.
std::shared_ptr<RenderScene> wall(Rgb color) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes.push_back(boxMesh({1, 20, 20}));
  scene->instances = {{0, 0, Pose3(Eigen::Translation3d(2.5, 0, 0)), color, "wall", true}};
  scene->ambient = 0.5F;
  return scene;
}

Image pictureOf(const std::shared_ptr<const RenderScene>& scene, const LightAdjustment& lighting,
                const CameraModel& camera = {}, PixelFormat format = PixelFormat::kRgb8) {
  CameraRenderer renderer(scene, {});
  renderer.setLighting(lighting);
  Image image;
  renderer.render(Pose3::Identity(), camera, format, {}, image);
  return image;
}

}  // namespace

TEST(CameraLabels, everyPixelNamesTheInstanceWhoseColorItHas) {
  for (const CameraScene& scene : {glowing(fieldScene()), glowing(tableScene())}) {
    CameraRenderer renderer(scene.scene, {});
    renderer.setPoses(scene.poses);
    Image image, labels;
    int seen = 0;
    for (const Pose3& camera : scene.cameras) {
      renderer.render(camera, {}, PixelFormat::kRgb8, {}, image);
      renderer.label(numbersOf(*scene.scene), kNothing, labels);
      ASSERT_EQ(labels.format, PixelFormat::kMono8);
      ASSERT_EQ(labels.data.size(), image.data.size() / 3);
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          const Rgb color = pixel(image, x, y);
          const int instance = color.r | color.g << 8;
          ASSERT_EQ(labels.row(y)[x], color == kNobody ? kNothing : instance % kNothing) << x << ", " << y;
          seen += color == kNobody ? 0 : 1;
        }
      }
    }
    EXPECT_GT(seen, 20'000) << "pixels with a body";
  }
}

TEST(CameraLabels, areTheSameWhateverLightNoiseLensFormatAndArithmetic) {
  const CameraScene scene = fieldScene();
  CameraRenderer plain(scene.scene, {true, Arithmetic::kPortable}), other(scene.scene, {false});
  plain.setPoses(scene.poses);
  other.setPoses(scene.poses);
  other.setLighting({0.3, -0.5});
  CameraModel camera;
  Image image, labels, otherLabels;
  for (const Pose3& pose : scene.cameras) {
    camera.vignetting = {};
    plain.render(pose, camera, PixelFormat::kYuyv, {}, image);
    plain.label(numbersOf(*scene.scene), kNothing, labels);
    camera.vignetting = {0.5, 0.2};
    other.render(pose, camera, PixelFormat::kRgb8, {5, 1, 1, 1}, image);
    other.label(numbersOf(*scene.scene), kNothing, otherLabels);
    EXPECT_EQ(labels, otherLabels);
  }
}

TEST(CameraLabels, missingOnesAreBackgroundAndThereAreNoneBeforeAnImage) {
  CameraRenderer renderer(wall({200, 100, 50}), {});
  Image image, labels;
  renderer.label({}, 1, labels);
  EXPECT_TRUE(labels.data.empty());
  renderer.render(Pose3::Identity(), {9, 5}, PixelFormat::kYuyv, {}, image);
  renderer.label({}, 7, labels);
  EXPECT_EQ(labels.width, 8) << "as the image";
  EXPECT_EQ(labels.data, std::vector<std::uint8_t>(40, 7));
  const std::uint8_t number = 3;
  renderer.label({&number, 1}, 7, labels);
  EXPECT_EQ(labels.data, std::vector<std::uint8_t>(40, 3));
}

TEST(CameraLighting, brightnessAndWarmthChangeColorsAsTheyAreDescribed) {
  const auto scene = wall({200, 100, 50});
  EXPECT_EQ(pixel(pictureOf(scene, {}), 3, 3), (Rgb{100, 50, 25}));
  EXPECT_EQ(pixel(pictureOf(scene, {0.5, 0}), 3, 3), (Rgb{50, 25, 13}));
  EXPECT_EQ(pixel(pictureOf(scene, {1, 0.4}), 3, 3), (Rgb{100, 40, 15})) << "lacks blue and some green";
  EXPECT_EQ(pixel(pictureOf(scene, {1, -0.4}), 3, 3), (Rgb{60, 40, 25})) << "lacks red and some green";
  EXPECT_EQ(pixel(pictureOf(scene, {5, 0}), 3, 3), (Rgb{200, 100, 50})) << "never brighter than the surface";
  scene->lamps = {{{0, 0, 0}, 0.5F, 0}};
  EXPECT_EQ(pixel(pictureOf(scene, {0.5, 0}, {1, 1}), 0, 0), (Rgb{100, 50, 25})) << "lamps, too";
}

TEST(CameraLighting, theBackgroundChangesAsWell) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->background = {100, 120, 140};
  EXPECT_EQ(pixel(pictureOf(scene, {}), 3, 3), (Rgb{100, 120, 140}));
  EXPECT_EQ(pixel(pictureOf(scene, {0.5, 0.2}), 3, 3), (Rgb{50, 54, 56}));
  EXPECT_EQ(pixel(pictureOf(scene, {3, 0}), 3, 3), (Rgb{100, 120, 140}));
}

TEST(CameraVignetting, lightAndRedAndGreenFallOffWithTheSquareOfTheDistance) {
  CameraModel camera;
  camera.vignetting = {0.4, 0.25};
  const Rgb full{100, 50, 25};
  const auto scene = wall({200, 100, 50});
  const Image rgb = pictureOf(scene, {}, camera);
  const Image yuyv = pictureOf(scene, {}, camera, PixelFormat::kYuyv);
  const double corner = std::pow(camera.width / 2.0, 2) + std::pow(camera.height / 2.0, 2);
  for (int y = 0; y < camera.height; y += 7) {
    for (int x = 0; x < camera.width; ++x) {
      const double r2 =
          (std::pow(x + 0.5 - camera.width / 2.0, 2) + std::pow(y + 0.5 - camera.height / 2.0, 2)) / corner;
      const double gain = 1 - 0.4 * r2, tinted = gain * (1 - 0.25 * r2);
      const Rgb at = pixel(rgb, x, y);
      ASSERT_NEAR(at.r, full.r * tinted, 0.51) << x << ", " << y;
      ASSERT_NEAR(at.g, full.g * tinted, 0.51);
      ASSERT_NEAR(at.b, full.b * gain, 0.51);
      const robotlink::YCbCr expected = robotlink::toYCbCr(at),
                             luma = robotlink::yuyvPixel(yuyv.view(), x, y);
      ASSERT_NEAR(luma.y, expected.y, 1);
      ASSERT_NEAR(luma.cb, expected.cb, 1.5);
      ASSERT_NEAR(luma.cr, expected.cr, 1.5);
    }
  }
  EXPECT_NEAR(pixel(rgb, 0, 0).r, 100 * 0.6 * 0.75, 1.5);
}

TEST(CameraVignetting, bothArithmeticsGiveTheSameBytes) {
  const CameraScene scene = fieldScene();
  CameraRenderer fastest(scene.scene, {true, Arithmetic::kFastest}),
      portable(scene.scene, {true, Arithmetic::kPortable});
  CameraModel camera;
  camera.vignetting = {0.3, 0.1};
  for (CameraRenderer* renderer : {&fastest, &portable}) {
    renderer->setPoses(scene.poses);
    renderer->setLighting({0.7, 0.3});
  }
  for (const PixelFormat format : {PixelFormat::kYuyv, PixelFormat::kRgb8}) {
    Image a, b;
    fastest.render(scene.cameras.front(), camera, format, {3, 1, 2, 3}, a);
    portable.render(scene.cameras.front(), camera, format, {3, 1, 2, 3}, b);
    EXPECT_EQ(a, b);
  }
}
