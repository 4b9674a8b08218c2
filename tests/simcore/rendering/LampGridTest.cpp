// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampGrid.h"

#include <gtest/gtest.h>

#include "robotlink/base/Random.h"

using namespace simcore;
using namespace simcore::rendering;
using Eigen::Vector3d;

namespace {

Vector3d randomPoint(robotlink::Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace

TEST(LampGrid, knowsNothingNearWhereNothingIs) {
  const LampGrid grid({1, 2, 3});
  EXPECT_GT(grid.nearest({5, 2, 1}, -1), 1e6);
}

TEST(LampGrid, aSphereIsNeverFartherThanItsBoundSays) {
  robotlink::Random random(1);
  for (int round = 0; round < 300; ++round) {
    const Vector3d lamp = randomPoint(random);
    LampGrid grid(lamp);
    const Sphere sphere{3 * randomPoint(random), random.uniform(0.01, 1.0)};
    grid.beginMoving();
    grid.addMoving(sphere, 5);
    for (int i = 0; i < 50; ++i) {
      const Vector3d point = sphere.center + sphere.radius * randomPoint(random).normalized();
      EXPECT_LE(grid.nearest(point, -1), (point - lamp).squaredNorm()) << round;
    }
  }
}

TEST(LampGrid, aTriangleIsNeverFartherThanItsBoundSays) {
  robotlink::Random random(2);
  for (int round = 0; round < 20; ++round) {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) mesh.vertices.push_back((3 * randomPoint(random)).cast<float>());
    mesh.triangles = {{0, 1, 2}};
    const Vector3d lamp = randomPoint(random);
    LampGrid grid(lamp);
    grid.addStatic(mesh, Pose3::Identity(), 5);
    grid.beginMoving();
    for (int i = 0; i < 200; ++i) {
      double a = random.uniform(), b = random.uniform();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const Vector3d point =
          (mesh.vertices[0] + static_cast<float>(a) * (mesh.vertices[1] - mesh.vertices[0]) +
           static_cast<float>(b) * (mesh.vertices[2] - mesh.vertices[0]))
              .cast<double>();
      EXPECT_LE(grid.nearest(point, -1), (point - lamp).squaredNorm() * (1 + 1e-6)) << round;
    }
  }
}

TEST(LampGrid, movingCastersAreForgottenAndTheOthersStay) {
  LampGrid grid({0, 0, 3});
  grid.addStatic(boxMesh({0.2F, 0.2F, 0.2F}), Pose3::Identity(), 1);
  grid.beginMoving();
  grid.addMoving({{0, 0, 1.5}, 0.1}, 2);
  EXPECT_NEAR(grid.nearest({0, 0, 0}, -1), 1.4 * 1.4, 0.01);
  grid.beginMoving();
  EXPECT_NEAR(grid.nearest({0, 0, 0}, -1), 2.9 * 2.9, 0.5);
  EXPECT_GT(grid.nearest({0, 0, 0}, 1), 1e6) << "one instance may be left out";
}

TEST(LampGrid, leavingTheNearestOutGivesTheSecond) {
  LampGrid grid({0, 0, 3});
  grid.beginMoving();
  grid.addMoving({{0, 0, 2}, 0.1}, 1);
  grid.addMoving({{0, 0, 1.9}, 0.1}, 1);
  grid.addMoving({{0, 0, 1}, 0.1}, 2);
  EXPECT_NEAR(grid.nearest({0, 0, 0}, -1), 0.81, 0.01);
  EXPECT_NEAR(grid.nearest({0, 0, 0}, 1), 1.9 * 1.9, 0.01);
  EXPECT_NEAR(grid.nearest({0, 0, 0}, 2), 0.81, 0.01);
}

TEST(LampGrid, aLampInsideASphereIsShadedAllAround) {
  LampGrid grid({0, 0, 0});
  grid.beginMoving();
  grid.addMoving({{0.1, 0, 0}, 0.5}, 1);
  for (const Vector3d& point :
       {Vector3d(1, 0, 0), Vector3d(-1, 0.2, 0), Vector3d(0, 0, -1), Vector3d(1, 1, 1)}) {
    EXPECT_EQ(grid.nearest(point, -1), 0);
  }
}
