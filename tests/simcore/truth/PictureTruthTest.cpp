// SPDX-License-Identifier: GPL-3.0-or-later
// Images, depths and classes of the rasterizer against one ray of Embree for each pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "robotlink/base/Random.h"
#include "simcore/rendering/RayCaster.h"
#include "tests/simcore/CameraScenes.h"
#include "tests/simcore/ReferenceCamera.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

using robotlink::Image;
using robotlink::kPi;
using robotlink::PixelFormat;
using test::CameraScene;
using test::lookAt;

constexpr double kLargestShare = 0.1;  // per cent

/// A bumpy torus of 12,800 triangles, which hides itself.
Mesh bumpyTorus() {
  constexpr std::uint32_t kAround = 160, kAcross = 40;
  Mesh mesh;
  for (std::uint32_t i = 0; i < kAround * kAcross; ++i) {
    const double a = 2 * kPi * (i / kAcross) / kAround, b = 2 * kPi * (i % kAcross) / kAcross;
    const double thick = 0.1 + 0.02 * std::sin(9 * a) * std::cos(5 * b);
    const Eigen::Vector3d out(std::cos(a), std::sin(a), 0);
    const Eigen::Vector3d normal = out * std::cos(b) + Eigen::Vector3d(0, 0, std::sin(b));
    mesh.vertices.push_back((0.3 * out + thick * normal).cast<float>());
    mesh.normals.push_back(normal.cast<float>());
  }
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t k = 0; k < kAcross; ++k) {
      const std::uint32_t next = (i + 1) % kAround, beside = (k + 1) % kAcross;
      const std::uint32_t a = i * kAcross + k, b = next * kAcross + k, c = next * kAcross + beside,
                          d = i * kAcross + beside;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

Pose3 placed(const Eigen::Vector3d& at, double angle, const Eigen::Vector3d& axis) {
  return Eigen::Translation3d(at) * Pose3(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Meshes, spheres, cylinders, capsules and boxes, each on a body of its own, in the light of three lamps.
CameraScene exhibition() {
  auto scene = std::make_shared<RenderScene>();
  std::vector<Pose3> poses{Pose3::Identity()};
  scene->bodies = {"world"};
  scene->ambient = 0.3F;
  scene->background = {20, 30, 60};
  scene->lamps = {{{1, 0.5F, 2}, 0.4F, 0.1F}, {{-1.5F, -1, 1.5F}, 0.3F, 0}, {{0, 2, 3}, 0.2F, 0.02F}};
  const auto add = [&](Mesh mesh, const Pose3& pose, Rgb color) {
    const std::string name = "body" + std::to_string(scene->bodies.size());
    scene->instances.push_back({static_cast<int>(scene->meshes.size()),
                                static_cast<int>(scene->bodies.size()), Pose3::Identity(), color, name,
                                true});
    scene->meshes.push_back(std::move(mesh));
    scene->bodies.push_back(name);
    poses.push_back(pose);
  };
  add(boxMesh({5, 5, 0.1F}), placed({0, 0, -0.05}, 0, {0, 0, 1}), {90, 150, 90});
  add(bumpyTorus(), placed({0, 0, 0.45}, 0.9, {1, 1, 0}), {220, 60, 60});
  add(sphereMesh(0.2F, 40), placed({0.7, -0.4, 0.2}, 0, {0, 0, 1}), {240, 160, 20});
  add(cylinderMesh(0.15F, 0.5F, 48), placed({-0.6, 0.5, 0.4}, 0.5, {1, 0, 0}), {60, 60, 230});
  add(capsuleMesh(0.08F, 0.4F, 24), placed({0.5, 0.7, 0.3}, 1.2, {0, 1, 1}), {230, 60, 200});
  add(boxMesh({0.3F, 0.2F, 0.5F}), placed({-0.5, -0.6, 0.25}, 0.6, {0, 0, 1}), {200, 200, 200});
  robotlink::Random random(3);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d at{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(0.1, 1)};
    add(sphereMesh(static_cast<float>(random.uniform(0.02, 0.08)), 8), placed(at, 1, {1, 2, 3}),
        {static_cast<std::uint8_t>(60 + 6 * i), static_cast<std::uint8_t>(250 - 5 * i), 120});
  }
  return {scene,
          std::move(poses),
          {lookAt({1.8, 1.0, 0.9}, {0, 0, 0.3}), lookAt({-1.6, 0.9, 0.5}, {0, 0, 0.3}),
           lookAt({0.2, -0.1, 2.5}, {0, 0, 0}), lookAt({0.3, -1.9, 0.15}, {0, 0, 0.4})}};
}

/// The scenes with the cameras that are outside of all bodies, because the rays of distances see surfaces
/// from inside, too.
std::vector<CameraScene> scenes() {
  CameraScene table = test::tableScene();
  table.cameras = {table.cameras[0], table.cameras[1], table.cameras[2], table.cameras[5]};
  CameraScene field = test::fieldScene();
  field.cameras.resize(4);
  return {exhibition(), std::move(table), std::move(field)};
}

const CameraModel kCameras[] = {{}, {320, 240, 1.2, 0.95}};

/// The share of pixels, per cent, for which `differs` holds, over all cameras of a scene and both sizes.
template <typename Differing>
double shareOf(const CameraScene& scene, Differing differing) {
  double count = 0, all = 0;
  for (const CameraModel& camera : kCameras) {
    for (const Pose3& place : scene.cameras) {
      count += differing(place, camera);
      all += camera.width * camera.height;
    }
  }
  return 100 * count / all;
}

TEST(PictureTruth, everyPixelHasTheColorThatItsRayFinds) {
  for (const CameraScene& scene : scenes()) {
    for (const bool shadows : {false, true}) {
      CameraRenderer renderer(scene.scene, {shadows});
      test::ReferenceCamera reference(scene.scene, shadows);
      renderer.setPoses(scene.poses);
      reference.setPoses(scene.poses);
      Image ours, theirs;
      const double share = shareOf(scene, [&](const Pose3& place, const CameraModel& camera) {
        renderer.render(place, camera, PixelFormat::kRgb8, {}, ours);
        reference.render(place, camera, theirs);
        int count = 0;
        for (std::size_t i = 0; i < ours.data.size(); i += 3) {
          int largest = 0;
          for (std::size_t k = 0; k < 3; ++k)
            largest = std::max(largest, std::abs(ours.data[i + k] - theirs.data[i + k]));
          count += largest > 4 ? 1 : 0;
        }
        return count;
      });
      compare({shadows ? "colors with shadows, pixels that differ by more than 4 / 255"
                       : "colors, pixels that differ by more than 4 / 255",
               "one ray of Embree a pixel", 0, kLargestShare, "%"},
              share);
    }
  }
}

TEST(PictureTruth, everyPixelHasTheClassThatItsRayFinds) {
  for (const CameraScene& scene : scenes()) {
    // Each instance is seen in a color of its own, in full light, by the reference.
    auto colored = std::make_shared<RenderScene>(*scene.scene);
    colored->lamps.clear();
    colored->ambient = 1;
    colored->background = {255, 255, 255};
    std::vector<float> numbers;
    for (std::size_t i = 0; i < colored->instances.size(); ++i) {
      colored->instances[i].color = {static_cast<std::uint8_t>(i % 200), static_cast<std::uint8_t>(i / 200),
                                     0};
      numbers.push_back(static_cast<float>(i));
    }
    CameraRenderer renderer(scene.scene, {});
    test::ReferenceCamera reference(colored, false);
    renderer.setPoses(scene.poses);
    reference.setPoses(scene.poses);
    Image theirs;
    const double share = shareOf(scene, [&](const Pose3& place, const CameraModel& camera) {
      std::vector<float> depth(static_cast<std::size_t>(camera.width * camera.height)), ours(depth.size());
      renderer.renderDepth(place, camera, depth);
      renderer.labelValues(numbers, -1, ours);
      reference.render(place, camera, theirs);
      int count = 0;
      for (std::size_t i = 0; i < ours.size(); ++i) {
        const std::uint8_t* color = &theirs.data[3 * i];
        const float number = color[2] == 255 ? -1 : static_cast<float>(color[0] + 200 * color[1]);
        count += ours[i] == number ? 0 : 1;
      }
      return count;
    });
    compare({"classes, pixels that differ", "one ray of Embree a pixel", 0, kLargestShare, "%"}, share);
  }
}

TEST(PictureTruth, everyPixelHasTheDepthThatItsRayFinds) {
  for (const CameraScene& scene : scenes()) {
    CameraRenderer renderer(scene.scene, {});
    RayCaster caster(scene.scene);
    renderer.setPoses(scene.poses);
    caster.setPoses(scene.poses);
    const double share = shareOf(scene, [&](const Pose3& place, const CameraModel& camera) {
      std::vector<float> depth(static_cast<std::size_t>(camera.width * camera.height));
      renderer.renderDepth(place, camera, depth);
      const double focalX = camera.width / 2.0 / std::tan(camera.horizontalAngle / 2);
      const double focalY = camera.height / 2.0 / std::tan(camera.verticalAngle / 2);
      int count = 0;
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          const Eigen::Vector3d ray(1, (camera.width / 2.0 - x - 0.5) / focalX,
                                    (camera.height / 2.0 - y - 0.5) / focalY);
          const auto hit = caster.firstHit(place.translation(), place.linear() * ray, 100);
          const double expected = hit ? hit->distance / ray.norm() : std::numeric_limits<double>::infinity();
          const double ours = depth[static_cast<std::size_t>(y * camera.width + x)];
          const bool same = ours == expected || std::abs(ours - expected) <= 1e-3 * expected;
          count += same ? 0 : 1;
        }
      }
      return count;
    });
    compare(
        {"depths, pixels that differ by more than 0.1 %", "one ray of Embree a pixel", 0, kLargestShare, "%"},
        share);
  }
}

}  // namespace
}  // namespace simcore::truth
