// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/RayCaster.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <thread>

#include "simcore/rendering/BodyTree.h"
#include "tests/simcore/CameraScenes.h"

using namespace simcore;
using Eigen::Vector3d;

namespace {

/// A floor, a box whose front is at x = 1, and a ball of radius 0.1 at (0.5, 0, 0.5).
struct Room {
  std::shared_ptr<RenderScene> scene = std::make_shared<RenderScene>();
  std::vector<Pose3> poses{3, Pose3::Identity()};

  Room() {
    scene->bodies = {"world", "box", "ball"};
    scene->meshes = {boxMesh({10, 10, 1}), boxMesh({1, 1, 1}), sphereMesh(0.1F, 64)};
    scene->instances = {{0, 0, Pose3(Eigen::Translation3d(0, 0, -0.5)), {}, "floor", false},
                        {1, 1, Pose3::Identity(), {}, "box", true},
                        {2, 2, Pose3::Identity(), {}, "ball", true}};
    poses[1].translation() = Vector3d(1.5, 0, 0.5);
    poses[2].translation() = Vector3d(0.5, 0, 0.5);
  }
};

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

TEST(RayCaster, distancesAreThoseOfGeometry) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  const auto down = caster.firstHit({-1, 2, 0.75}, {0, 0, -1}, kFar);
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->distance, 0.75, 1e-6);
  EXPECT_EQ(down->body, 0) << "what casts no shadow is hit all the same";
  const auto slanting = caster.firstHit({-1, 2, 1}, {1, -1, -1}, kFar);
  ASSERT_TRUE(slanting);
  EXPECT_NEAR(slanting->distance, std::sqrt(3), 1e-5);
  const auto ball = caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->distance, 1.4, 2e-4);
  EXPECT_EQ(ball->body, 2);
}

TEST(RayCaster, theLengthOfADirectionDoesNotMatter) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  for (const double length : {0.01, 1.0, 250.0}) {
    const auto hit = caster.firstHit({-1, 0.3, 0.5}, {length, 0, 0}, kFar);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 2, 1e-5);
  }
}

TEST(RayCaster, excludedBodiesLetRaysPass) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  const std::array excluded = {2};
  const auto behind = caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar, excluded);
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->body, 1);
  EXPECT_NEAR(behind->distance, 2, 1e-5);
  const std::array both = {1, 2};
  EXPECT_FALSE(caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar, both));
}

TEST(RayCaster, nothingIsHitPastTheMaximum) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  EXPECT_FALSE(caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, 1.39));
  EXPECT_TRUE(caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, 1.41));
  EXPECT_FALSE(caster.firstHit({-1, 0, 0.5}, {0, 0, 1}, kFar));
}

TEST(RayCaster, bodiesAreWhereTheyWerePutLast) {
  Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  room.poses[2].translation().x() = 0.2;
  room.poses[1].rotate(Eigen::AngleAxisd(robotlink::kPi / 4, Vector3d::UnitZ()));
  caster.setPoses(room.poses);
  EXPECT_NEAR(caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar)->distance, 1.1, 2e-4);
  const std::array excluded = {2};
  EXPECT_NEAR(caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar, excluded)->distance, 2.5 - std::sqrt(0.5), 1e-5);
}

TEST(RayCaster, severalThreadsMayAskAtOnce) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  std::array<int, 3> wrong{};
  std::vector<std::thread> threads;
  for (int& count : wrong) {
    threads.emplace_back([&caster, &count] {
      for (int i = 0; i < 500; ++i) {
        const auto hit = caster.firstHit({-1, 0, 0.5}, {1, 0, 0}, kFar);
        if (!hit || hit->body != 2) ++count;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, (std::array<int, 3>{}));
}

TEST(RayCaster, surfacesAreHitFromInsideToo) {
  const Room room;
  RayCaster caster(room.scene);
  caster.setPoses(room.poses);
  EXPECT_NEAR(caster.firstHit({0.5, 0, 0.5}, {0, 1, 0}, kFar)->distance, 0.1, 2e-4);
}

TEST(RayCaster, anEmptySceneHasNothingToHit) {
  RayCaster caster(std::make_shared<RenderScene>());
  caster.setPoses({});
  EXPECT_FALSE(caster.firstHit({0, 0, 0}, {1, 0, 0}, kFar));
}

TEST(RayCaster, anglesOfACirclesRaysGiveTheWallsOfARoom) {
  // As a laser in a square room of 2 m turns, distances are 1 / max(|cos|, |sin|).
  auto scene = std::make_shared<RenderScene>();
  scene->meshes = {boxMesh({2, 2, 2})};
  scene->instances = {{0, 0, Pose3::Identity(), {}, "room", true}};
  RayCaster caster(scene);
  for (int i = 0; i < 181; ++i) {
    const double angle = robotlink::radians(2 * i), c = std::cos(angle), s = std::sin(angle);
    const auto hit = caster.firstHit({0, 0, 0.1}, {c, s, 0}, kFar);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 1 / std::max(std::abs(c), std::abs(s)), 1e-5);
  }
}

TEST(RayCaster, raysAreTracedOnProcessorsWithoutAvx2Too) {
  const Room room;
  const RTCDevice device = rendering::newRayDevice(rendering::RayInstructions::kSse2);
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED), 0) << "packets of AVX";
  {
    rendering::BodyTrees trees(device, *room.scene, rendering::Contents::kEverything);
    const RTCScene ball = trees.treeOf(2);
    ASSERT_NE(ball, nullptr);
    alignas(32) const int valid[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
    alignas(32) RTCRay8 rays{};
    for (int i = 0; i < 8; ++i) {
      rays.org_x[i] = -1;
      rays.org_z[i] = 0.05F * static_cast<float>(i);  // past the ball from the third on
      rays.dir_x[i] = 1;
      rays.tfar[i] = 10;
      rays.mask[i] = ~0U;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid, ball, &context, &rays);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(rays.tfar[i] < 0, i < 2) << i;
    rtcReleaseScene(ball);
  }
  EXPECT_EQ(rtcGetDeviceError(device), RTC_ERROR_NONE);
  rtcReleaseDevice(device);
}
