// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/CameraRenderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <thread>

#include "tests/simcore/CameraScenes.h"
#include "tests/simcore/ReferenceCamera.h"

using namespace simcore;
using namespace simcore::test;
using robotlink::Image;
using robotlink::PixelFormat;

namespace {

using Arithmetic = CameraRenderer::Arithmetic;

Image drawn(const CameraScene& scene, const CameraRenderer::Options& options, const Pose3& camera,
            const CameraModel& model = {}, PixelFormat format = PixelFormat::kRgb8,
            const ImageNoise& noise = {}) {
  CameraRenderer renderer(scene.scene, options);
  renderer.setPoses(scene.poses);
  Image image;
  renderer.render(camera, model, format, noise, image);
  return image;
}

/// Pixels that differ by more than 4 in any channel of two RGB images.
int differingPixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.data.size(); i += 3) {
    int largest = 0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(a.data[i + k] - b.data[i + k]));
    if (largest > 4) ++count;
  }
  return count;
}

/// A single mesh at the origin without lamps, in full light.
CameraScene single(Mesh mesh, Rgb color, Rgb background) {
  auto scene = std::make_shared<RenderScene>();
  scene->meshes.push_back(std::move(mesh));
  scene->instances.push_back({0, 0, Pose3::Identity(), color, "single", true});
  scene->bodies = {"world"};
  scene->ambient = 1;
  scene->background = background;
  return {scene, {Pose3::Identity()}, {}};
}

/// The share of differing pixels over all cameras, per cent.
double disagreement(const CameraScene& scene, bool shadows, const CameraModel& model) {
  CameraRenderer renderer(scene.scene, {shadows});
  ReferenceCamera reference(scene.scene, shadows);
  renderer.setPoses(scene.poses);
  reference.setPoses(scene.poses);
  int different = 0;
  Image ours, theirs;
  for (const Pose3& camera : scene.cameras) {
    renderer.render(camera, model, PixelFormat::kRgb8, {}, ours);
    reference.render(camera, model, theirs);
    different += differingPixels(ours, theirs);
  }
  return 100.0 * different /
         (static_cast<double>(model.width * model.height) * static_cast<double>(scene.cameras.size()));
}

}  // namespace

TEST(CameraRenderer, agreesWithEmbreeWithoutShadows) {
  for (const CameraScene& scene : {fieldScene(), tableScene()}) {
    EXPECT_LE(disagreement(scene, false, {}), 0.1) << "per cent of the pixels";
  }
}

TEST(CameraRenderer, agreesWithEmbreeWithShadows) {
  for (const CameraScene& scene : {fieldScene(), tableScene()}) {
    EXPECT_LE(disagreement(scene, true, {}), 0.2) << "per cent of the pixels";
  }
}

TEST(CameraRenderer, agreesWithEmbreeAtOtherSizes) {
  for (const auto& [width, height] : {std::pair{175, 143}, {9, 5}, {320, 24}, {23, 240}, {33'000, 2}}) {
    const CameraModel model{width, height, robotlink::radians(70), robotlink::radians(60)};
    EXPECT_LE(disagreement(tableScene(), true, model), 0.2) << width << "x" << height;
  }
}

TEST(CameraRenderer, bothArithmeticsGiveTheSameBytes) {
  for (const CameraScene& scene : {fieldScene(), tableScene()}) {
    CameraRenderer fastest(scene.scene, {true, Arithmetic::kFastest});
    CameraRenderer portable(scene.scene, {true, Arithmetic::kPortable});
    fastest.setPoses(scene.poses);
    portable.setPoses(scene.poses);
    for (const PixelFormat format : {PixelFormat::kYuyv, PixelFormat::kRgb8}) {
      for (const Pose3& camera : scene.cameras) {
        Image a, b;
        fastest.render(camera, {}, format, {3.0, 1, 2, 3}, a);
        portable.render(camera, {}, format, {3.0, 1, 2, 3}, b);
        EXPECT_EQ(a, b);
      }
    }
  }
}

TEST(CameraRenderer, theSameInputsGiveTheSameBytesWhateverWasDrawnBefore) {
  const CameraScene scene = fieldScene();
  CameraRenderer renderer(scene.scene, {});
  renderer.setPoses(scene.poses);
  Image first, other, again;
  renderer.render(scene.cameras[4], {}, PixelFormat::kYuyv, {2.0, 1, 1, 7}, first);
  std::vector<Pose3> moved = scene.poses;
  for (std::size_t i = 1; i < moved.size(); ++i) moved[i].pretranslate(Eigen::Vector3d(0.1, 0.05, 0));
  renderer.setPoses(moved);
  renderer.render(scene.cameras[2], {33, 20, 1.0, 1.0}, PixelFormat::kRgb8, {}, other);
  renderer.render(scene.cameras[4], {}, PixelFormat::kYuyv, {2.0, 1, 1, 7}, other);
  EXPECT_NE(first, other);
  renderer.setPoses(scene.poses);
  renderer.render(scene.cameras[4], {}, PixelFormat::kYuyv, {2.0, 1, 1, 7}, again);
  EXPECT_EQ(first, again);
}

TEST(CameraRenderer, severalThreadsMayShareAScene) {
  const CameraScene scene = tableScene();
  const Image expected = drawn(scene, {}, scene.cameras[0]);
  std::array<Image, 3> images;
  std::vector<std::thread> threads;
  for (Image& image : images) {
    threads.emplace_back([&scene, &image] {
      for (int i = 0; i < 3; ++i) image = drawn(scene, {}, scene.cameras[0]);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Image& image : images) EXPECT_EQ(image, expected);
}

TEST(CameraRenderer, renderersThatSharePosesDrawTheSameInSeveralThreads) {
  const CameraScene scene = tableScene();
  CameraRenderer first(scene.scene, {});
  const auto second = first.another();
  second->setPoses(scene.poses);
  first.place();
  Image images[2];
  {
    const auto draw = [&](CameraRenderer& renderer, std::size_t camera) {
      renderer.render(scene.cameras[camera], {}, PixelFormat::kRgb8, {}, images[camera]);
    };
    std::jthread one([&] { draw(first, 0); });
    std::jthread other([&] { draw(*second, 1); });
  }
  for (const std::size_t camera : {0U, 1U})
    EXPECT_EQ(images[camera].data, drawn(scene, {}, scene.cameras[camera]).data);
}

TEST(CameraRenderer, anEmptySceneShowsItsBackground) {
  auto scene = std::make_shared<RenderScene>();
  scene->background = {12, 130, 250};
  scene->lamps.push_back({});
  CameraRenderer renderer(scene, {});
  Image image;
  renderer.render(Pose3::Identity(), {}, PixelFormat::kRgb8, {}, image);
  ASSERT_EQ(image.width, 176);
  ASSERT_EQ(image.height, 144);
  for (int x = 0; x < 176; ++x) EXPECT_EQ(pixel(image, x, 143), scene->background);
  renderer.render(Pose3::Identity(), {}, PixelFormat::kYuyv, {}, image);
  EXPECT_EQ(robotlink::yuyvPixel(image.view(), 175, 0), robotlink::toYCbCr(scene->background));
}

TEST(CameraRenderer, tinyAndOddSizesAreDrawn) {
  const CameraScene scene = single(sphereMesh(0.5F), {200, 100, 50}, {});
  const Pose3 camera = lookAt({-3, 0, 0}, {0, 0, 0});
  const Image one = drawn(scene, {}, camera, {1, 1, 0.2, 0.2});
  EXPECT_EQ(pixel(one, 0, 0), (Rgb{200, 100, 50}));
  const Image two = drawn(scene, {}, camera, {2, 2, 0.2, 0.2}, PixelFormat::kYuyv);
  EXPECT_EQ(robotlink::yuyvPixel(two.view(), 1, 1), robotlink::toYCbCr({200, 100, 50}));
  const Image odd = drawn(scene, {}, camera, {175, 143}, PixelFormat::kYuyv);
  EXPECT_EQ(odd.width, 174) << "a Yuyv image has pairs of pixels only";
  EXPECT_EQ(odd.data.size(), 174U * 143U * 2U);
  const Image none = drawn(scene, {}, camera, {1, 1}, PixelFormat::kYuyv);
  EXPECT_TRUE(none.data.empty());
}

TEST(CameraRenderer, leftIsLeftAndUpIsUp) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world", "left", "up"};
  scene->meshes.push_back(sphereMesh(0.2F));
  scene->ambient = 1;
  scene->instances = {{0, 1, Pose3::Identity(), {255, 0, 0}, "left", true},
                      {0, 2, Pose3::Identity(), {0, 0, 255}, "up", true}};
  std::vector<Pose3> poses(3, Pose3::Identity());
  poses[1].translation() = Eigen::Vector3d(2, 0.6, 0);
  poses[2].translation() = Eigen::Vector3d(2, 0, 0.6);
  const Image image = drawn({scene, poses, {}}, {}, Pose3::Identity());
  // A point at (2, 0.6, 0) is 0.6 / 2 of a focal length left of the center.
  EXPECT_EQ(pixel(image, 88 - 48, 72), (Rgb{255, 0, 0}));
  EXPECT_EQ(pixel(image, 88, 72 - 49), (Rgb{0, 0, 255}));
  EXPECT_EQ(pixel(image, 88, 72), (Rgb{0, 0, 0}));
}

TEST(CameraRenderer, aSurfaceIsLitAsTheFormulaSays) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->meshes.push_back(boxMesh({1, 10, 10}));
  scene->instances = {{0, 0, Pose3(Eigen::Translation3d(2.5, 0, 0)), {200, 100, 250}, "wall", true}};
  scene->ambient = 0.25F;
  scene->lamps = {{{0, 0, 2}, 0.8F, 0.5F}};
  const Image image = drawn({scene, {}, {}}, {}, Pose3::Identity(), {1, 1});
  // The wall's point (2, 0, 0) sees the lamp at 45 degrees and a squared distance of 8.
  const double light = 0.25 + 0.8 / (1 + 8 * 0.5) * std::sqrt(0.5);
  EXPECT_NEAR(pixel(image, 0, 0).r, 200 * light, 0.51);
  EXPECT_NEAR(pixel(image, 0, 0).g, 100 * light, 0.51);
  EXPECT_NEAR(pixel(image, 0, 0).b, 250 * light, 0.51);
}

TEST(CameraRenderer, yuyvIsTheRgbImageConverted) {
  const CameraScene scene = tableScene();
  CameraRenderer renderer(scene.scene, {});
  renderer.setPoses(scene.poses);
  Image rgb, yuyv;
  for (const Pose3& camera : scene.cameras) {
    renderer.render(camera, {}, PixelFormat::kRgb8, {}, rgb);
    renderer.render(camera, {}, PixelFormat::kYuyv, {}, yuyv);
    for (int y = 0; y < rgb.height; ++y) {
      for (int x = 0; x < rgb.width; x += 2) {
        const robotlink::YCbCr a = robotlink::toYCbCr(pixel(rgb, x, y)),
                               b = robotlink::toYCbCr(pixel(rgb, x + 1, y));
        const robotlink::YCbCr even = robotlink::yuyvPixel(yuyv.view(), x, y);
        ASSERT_NEAR(even.y, a.y, 1);
        ASSERT_NEAR(robotlink::yuyvPixel(yuyv.view(), x + 1, y).y, b.y, 1);
        ASSERT_NEAR(even.cb, (a.cb + b.cb) / 2.0, 1);
        ASSERT_NEAR(even.cr, (a.cr + b.cr) / 2.0, 1);
      }
    }
  }
}

TEST(CameraRenderer, aCameraInsideAMeshLooksOutOfIt) {
  const CameraScene scene = single(boxMesh({1, 1, 1}), {255, 0, 0}, {0, 255, 0});
  const Image image = drawn(scene, {}, Pose3::Identity());
  for (int x = 0; x < image.width; ++x) EXPECT_EQ(pixel(image, x, 72), (Rgb{0, 255, 0}));
}

TEST(CameraRenderer, aWallVeryNearFillsTheImage) {
  const CameraScene scene = single(boxMesh({1, 8, 8}), {255, 0, 0}, {0, 255, 0});
  for (const double distance : {1e-1, 1e-3, 1e-5}) {
    const Image image = drawn(scene, {}, lookAt({-0.5 - distance, 0.3, 0.2}, {0, 0.3, 0.2}));
    for (const int y : {0, 72, 143}) {
      for (int x = 0; x < image.width; ++x) ASSERT_EQ(pixel(image, x, y), (Rgb{255, 0, 0})) << distance;
    }
  }
}

TEST(CameraRenderer, trianglesThatPassTheCameraLeaveNoHoles) {
  // The camera's plane cuts the floor and many of its triangles.
  Mesh floor;
  constexpr int kCells = 9;
  for (int i = 0; i <= kCells; ++i) {
    for (int k = 0; k <= kCells; ++k) {
      floor.vertices.emplace_back(static_cast<float>(i) - 4.6F, static_cast<float>(k) * 1.1F - 4.7F, 0.0F);
      floor.normals.emplace_back(0.0F, 0.0F, 1.0F);
    }
  }
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t k = 0; k < kCells; ++k) {
      const std::uint32_t a = i * (kCells + 1) + k, b = a + kCells + 1;
      floor.triangles.push_back({a, b, b + 1});
      floor.triangles.push_back({a, b + 1, a + 1});
    }
  }
  const CameraScene scene = single(floor, {255, 0, 0}, {});
  for (const double tilt : {0.5, 1.0, 1.5, robotlink::kPi / 2}) {
    Pose3 camera = Pose3::Identity();
    camera.translation() = Eigen::Vector3d(-0.1, -0.2, 0.05);
    camera.rotate(Eigen::AngleAxisd(tilt, Eigen::Vector3d(0.02, 1, 0.01).normalized()));
    const Image image = drawn(scene, {}, camera);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) ASSERT_EQ(pixel(image, x, y), (Rgb{255, 0, 0})) << x << " " << y;
    }
  }
}

TEST(CameraRenderer, trianglesBetweenTheCentersOfPixelsMakeNoDifference) {
  // Most triangles of the ball are smaller than a pixel. With something behind the camera, which nobody sees,
  // their pixels are found in another way.
  const Mesh ball = sphereMesh(0.3F, 60);
  Mesh both = ball;
  const auto first = static_cast<std::uint32_t>(both.vertices.size());
  for (const Eigen::Vector3f& corner : {Eigen::Vector3f(-9, 0, 0), {-9, 1, 0}, {-9, 0, 1}}) {
    both.vertices.push_back(corner);
    both.normals.push_back(Eigen::Vector3f::UnitX());
  }
  both.triangles.push_back({first, first + 1, first + 2});
  const auto lit = [](Mesh mesh) {
    auto scene = std::make_shared<RenderScene>(*single(std::move(mesh), {200, 90, 30}, {0, 0, 60}).scene);
    scene->ambient = 0.2F;
    scene->lamps = {{{-1, 1, 2}, 0.8F, 0}};
    return CameraScene{scene, {Pose3::Identity()}, {}};
  };
  const CameraScene alone = lit(ball), withMore = lit(std::move(both));
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d from(-0.5 - 0.1 * i, 0.013 * i, 0.3), to(0, 0.02 * i, 0.01 * i);
    const Pose3 camera = lookAt(from, to);
    for (const CameraModel& model : {CameraModel{}, CameraModel{33, 21}}) {
      ASSERT_EQ(drawn(alone, {false}, camera, model), drawn(withMore, {false}, camera, model)) << i;
    }
  }
}

TEST(CameraRenderer, aLineOneMillimeterAboveTheCarpetNeverFlickers) {
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  scene->ambient = 1;
  scene->meshes = {boxMesh({12, 12, 0.1F}), boxMesh({2, 12, 0.001F})};
  Pose3 carpet = Pose3::Identity(), line = Pose3::Identity();
  carpet.translation().z() = -0.05;
  line.translation() = Eigen::Vector3d(4, 0, 0.0005);
  // Drawn in the order that would lose if depths were equal.
  scene->instances = {{0, 0, carpet, {0, 255, 0}, "carpet", true},
                      {1, 0, line, {255, 255, 255}, "line", true}};
  for (const double height : {0.1, 0.2, 3.0}) {
    const Image image = drawn({scene, {}, {}}, {}, lookAt({0, 0, height}, {4, 0, 0}));
    for (int x = 0; x < image.width; ++x) ASSERT_EQ(pixel(image, x, 72), (Rgb{255, 255, 255})) << height;
  }
}

TEST(CameraRenderer, aBodyCastsItsShadowUnlessItMustNot) {
  for (const bool casts : {true, false}) {
    auto scene = std::make_shared<RenderScene>();
    scene->bodies = {"world", "ball"};
    scene->ambient = 0.5F;
    scene->lamps = {{{0, 0, 2}, 0.5F, 0}};
    scene->meshes = {boxMesh({4, 4, 0.1F}), sphereMesh(0.1F)};
    Pose3 floor = Pose3::Identity(), ball = Pose3::Identity();
    floor.translation().z() = -0.05;
    ball.translation() = Eigen::Vector3d(0.5, 0, 1);
    scene->instances = {{0, 0, floor, {200, 200, 200}, "floor", true},
                        {1, 1, Pose3::Identity(), {200, 0, 0}, "ball", casts}};
    // The shadow's center is at (1, 0, 0): twice as far from the lamp as the ball.
    const Image image = drawn({scene, {Pose3::Identity(), ball}, {}}, {}, lookAt({1, -1, 0.5}, {1, 0, 0}));
    const double lit = 100 + 100 * 2 / std::sqrt(5.0);
    EXPECT_NEAR(pixel(image, 88, 72).r, casts ? 100 : lit, 2);
    EXPECT_NEAR(pixel(image, 10, 72).r, lit, 12);
  }
}

TEST(CameraRenderer, lampsInsideAndOnBodiesDoNotUpsetIt) {
  for (const float height : {0.5F, 1.0F, 1.1F}) {
    auto scene = std::make_shared<RenderScene>(*tableScene().scene);
    scene->lamps = {{{0, 0, height}, 1.0F, 0}};
    scene->meshes.push_back(sphereMesh(1));
    scene->instances.push_back(
        {static_cast<int>(scene->meshes.size()) - 1, 0, Pose3::Identity(), {9, 9, 9}, "dome", true});
    EXPECT_LE(disagreement({scene, tableScene().poses, tableScene().cameras}, true, {88, 72}), 0.2) << height;
  }
}
