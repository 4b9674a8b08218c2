// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/CameraScenes.h"

#include <array>

namespace simcore::test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using Eigen::Vector3f;
using robotlink::kPi;

constexpr Rgb kWhite{235, 235, 235}, kGreen{30, 130, 50}, kYellow{230, 210, 30}, kSkyblue{60, 150, 230},
    kPink{235, 90, 160}, kOrange{240, 110, 20}, kGray{120, 120, 125}, kRed{200, 30, 30}, kBlue{30, 40, 170};

Pose3 at(double x, double y, double z) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

Pose3 turned(Pose3 pose, double angle, const Vector3d& axis) {
  pose.rotate(AngleAxisd(angle, axis));
  return pose;
}

/// Puts a scene together; instances go to the body that was added last.
class SceneBuilder {
 public:
  SceneBuilder() { addBody("world", Pose3::Identity()); }

  void addBody(const std::string& name, const Pose3& pose) {
    scene_.bodies.push_back(name);
    poses_.push_back(pose);
  }
  int addMesh(Mesh mesh) {
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }
  void add(int mesh, const Pose3& pose, Rgb color, bool castsShadow = true) {
    scene_.instances.push_back(
        {mesh, static_cast<int>(scene_.bodies.size()) - 1, pose, color, scene_.bodies.back(), castsShadow});
  }
  void addBox(const Vector3d& size, const Pose3& pose, Rgb color, bool castsShadow = true) {
    add(addMesh(boxMesh(size.cast<float>())), pose, color, castsShadow);
  }
  RenderScene& scene() { return scene_; }
  CameraScene take(std::vector<Pose3> cameras) {
    return {std::make_shared<const RenderScene>(std::move(scene_)), std::move(poses_), std::move(cameras)};
  }

 private:
  RenderScene scene_;
  std::vector<Pose3> poses_;
};

void addCarpet(SceneBuilder& builder) {
  builder.addBox({4.6, 3.1, 0.02}, at(0, 0, -0.01), kGreen, false);
  const auto line = [&](double x, double y, double lengthX, double lengthY) {
    builder.addBox({lengthX, lengthY, 0.001}, at(x, y, 0.0005), kWhite, false);
  };
  line(0, 0, 0.025, 2.7);
  for (const double side : {-1.0, 1.0}) {
    line(side * 2.1, 0, 0.025, 2.7);
    line(side * 1.6, 0, 0.025, 1);
    for (const double y : {-0.5, 0.5}) line(side * 1.85, y, 0.475, 0.025);
  }
}

void addWalls(SceneBuilder& builder) {
  for (const double side : {-1.0, 1.0}) {
    builder.addBox({4.4, 0.1, 0.1}, at(0, side * 1.4, 0.05), kWhite);
    for (const double y : {-0.85, 0.85}) builder.addBox({0.1, 1.0, 0.1}, at(side * 2.15, y, 0.05), kWhite);
    const Rgb color = side < 0 ? kYellow : kSkyblue;
    builder.addBox({0.02, 0.6, 0.3}, at(side * 2.39, 0, 0.15), color);
    for (const double y : {-0.31, 0.31}) builder.addBox({0.26, 0.02, 0.3}, at(side * 2.25, y, 0.15), color);
    for (const double y : {-1.2, 1.2}) {
      builder.addBox({0.5, 0.02, 0.1}, turned(at(side * 1.96, y, 0.05), side * y * -0.65, Vector3d::UnitZ()),
                     kWhite);
    }
  }
}

void addBeacons(SceneBuilder& builder) {
  const int base = builder.addMesh(cylinderMesh(0.05F, 0.2F, 12)),
            band = builder.addMesh(cylinderMesh(0.05F, 0.1F, 12));
  for (const double x : {-2.2, 0.0, 2.2}) {
    for (const double y : {-1.45, 1.45}) {
      const Rgb side = x < 0 ? kYellow : x > 0 ? kSkyblue : kGreen;
      builder.add(base, at(x, y, 0.1), kWhite);
      builder.add(band, at(x, y, 0.25), y < 0 ? side : kPink);
      builder.add(band, at(x, y, 0.35), y < 0 ? kPink : side);
    }
  }
}

/// The meshes of a robot, shared by all.
struct RobotMeshes {
  int trunk, shoulder, upperLeg, lowerLeg, joint, paw, neck, head, snout, ear, tail, patch, eye;

  explicit RobotMeshes(SceneBuilder& builder)
      : trunk(builder.addMesh(capsuleMesh(0.035F, 0.16F, 8))),
        shoulder(builder.addMesh(sphereMesh(0.03F, 3))),
        upperLeg(builder.addMesh(capsuleMesh(0.018F, 0.06F, 8))),
        lowerLeg(builder.addMesh(capsuleMesh(0.014F, 0.06F, 8))),
        joint(builder.addMesh(sphereMesh(0.02F, 3))),
        paw(builder.addMesh(sphereMesh(0.0125F, 3))),
        neck(builder.addMesh(capsuleMesh(0.02F, 0.05F, 8))),
        head(builder.addMesh(sphereMesh(0.045F, 5))),
        snout(builder.addMesh(capsuleMesh(0.025F, 0.04F, 8))),
        ear(builder.addMesh(capsuleMesh(0.008F, 0.04F, 8))),
        tail(builder.addMesh(capsuleMesh(0.006F, 0.08F, 8))),
        patch(builder.addMesh(boxMesh({0.1F, 0.004F, 0.04F}))),
        eye(builder.addMesh(sphereMesh(0.008F, 3))) {}
};

void addLeg(SceneBuilder& builder, const RobotMeshes& meshes, const std::string& name, const Pose3& robot,
            const Vector3d& hip, double swing) {
  const Pose3 hipPose = robot * at(hip.x(), hip.y(), hip.z());
  builder.addBody(name + "/shoulder", hipPose);
  builder.add(meshes.shoulder, at(0, 0, 0), kGray);
  const Pose3 upper = turned(hipPose, swing, Vector3d::UnitY());
  builder.addBody(name + "/upper", upper);
  builder.add(meshes.upperLeg, at(0, 0, -0.035), kGray);
  builder.add(meshes.joint, at(0, 0, -0.065), kGray);
  const Pose3 lower = turned(upper * at(0, 0, -0.065), 0.6 - 2 * swing, Vector3d::UnitY());
  builder.addBody(name + "/lower", lower);
  builder.add(meshes.lowerLeg, at(0, 0, -0.025), kGray);
  builder.add(meshes.paw, at(0, 0, -0.055), kWhite);
  builder.add(meshes.joint, at(0, 0, -0.01), kGray);
}

/// Returns the camera's pose.
Pose3 addHead(SceneBuilder& builder, const RobotMeshes& meshes, const std::string& name, const Pose3& robot,
              double pan, double tilt) {
  Pose3 neck = turned(robot * at(0.075, 0, 0.05), tilt, Vector3d::UnitY());
  builder.addBody(name + "/neck", neck);
  builder.add(meshes.neck, at(0, 0, 0.02), kGray);
  neck = turned(neck * at(0, 0, 0.048), pan, Vector3d::UnitZ());
  builder.addBody(name + "/head", neck);
  builder.add(meshes.head, at(0.01, 0, 0), kGray);
  builder.add(meshes.snout, turned(at(0.04, 0, 0), kPi / 2, Vector3d::UnitY()), kGray);
  for (const double side : {-1.0, 1.0}) {
    builder.add(meshes.ear, at(-0.01, side * 0.045, 0.02), kGray);
    builder.add(meshes.eye, at(0.048, side * 0.02, 0.022), kRed);
  }
  return neck * at(0.1, 0, 0);
}

Pose3 addRobot(SceneBuilder& builder, const RobotMeshes& meshes, int index) {
  const std::string name = (index % 2 == 0 ? "red" : "blue") + std::to_string(index / 2 + 1);
  const Rgb patch = index % 2 == 0 ? kRed : kBlue;
  constexpr std::array<std::array<double, 3>, 8> kPlaces = {{{-1.9, 0.1, 0.1},
                                                             {1.95, -0.05, 3.1},
                                                             {-0.9, -0.7, 0.4},
                                                             {0.8, 0.75, -2.6},
                                                             {-0.6, 0.5, -0.5},
                                                             {0.9, -0.6, 2.6},
                                                             {-0.25, 0.1, -0.1},
                                                             {0.35, -0.2, 2.7}}};
  const auto& place = kPlaces[static_cast<std::size_t>(index)];
  const Pose3 robot =
      turned(turned(at(place[0], place[1], 0.13), place[2], Vector3d::UnitZ()), 0.08, Vector3d::UnitY());
  builder.addBody(name, robot);
  for (const double y : {-0.03, 0.0, 0.03}) {
    builder.add(meshes.trunk, turned(at(0, y, y == 0 ? 0.02 : 0), kPi / 2, Vector3d::UnitY()), kGray);
  }
  for (const double side : {-1.0, 1.0}) builder.add(meshes.patch, at(0, side * 0.067, 0.01), patch);
  for (const double front : {-1.0, 1.0}) {
    for (const double side : {-1.0, 1.0}) {
      addLeg(builder, meshes, name + "/leg", robot, {front * 0.06, side * 0.06, -0.005},
             0.3 * front * side - 0.2);
    }
  }
  builder.addBody(name + "/tail", turned(robot * at(-0.11, 0, 0.04), -0.5, Vector3d::UnitY()));
  builder.add(meshes.tail, at(0, 0, 0.04), kGray);
  return addHead(builder, meshes, name, robot, 0.12 * (index - 4), 0.1 + 0.02 * index);
}

}  // namespace

robotlink::Rgb pixel(const robotlink::Image& image, int x, int y) {
  const std::uint8_t* p = image.row(y) + 3 * x;
  return {p[0], p[1], p[2]};
}

Pose3 lookAt(const Vector3d& from, const Vector3d& to) {
  const Vector3d front = (to - from).normalized();
  const Vector3d up = std::abs(front.z()) > 0.99 ? Vector3d::UnitX() : Vector3d::UnitZ();
  const Vector3d left = up.cross(front).normalized();
  Pose3 pose = Pose3::Identity();
  pose.linear() << front, left, front.cross(left);
  pose.translation() = from;
  return pose;
}

CameraScene fieldScene() {
  SceneBuilder builder;
  builder.scene().background = {170, 170, 160};
  builder.scene().lamps.push_back({{0.5F, -0.3F, 3.0F}, 0.7F, 0.02F});
  addCarpet(builder);
  addWalls(builder);
  addBeacons(builder);
  builder.addBody("ball", at(0.05, 0.05, 0.042));
  builder.add(builder.addMesh(sphereMesh(0.042F, 10)), Pose3::Identity(), kOrange);
  const RobotMeshes meshes(builder);
  std::vector<Pose3> cameras;
  for (int robot = 0; robot < 8; ++robot) cameras.push_back(addRobot(builder, meshes, robot));
  return builder.take(std::move(cameras));
}

CameraScene tableScene() {
  SceneBuilder builder;
  builder.scene().background = {10, 20, 60};
  builder.scene().ambient = 0.3F;
  builder.scene().lamps = {{{1, 0.5F, 2}, 0.5F, 0.1F}, {{-1, -1, 1.5F}, 0.3F, 0}};
  builder.addBox({3, 3, 0.1}, at(0, 0, -0.05), kGreen);
  builder.addBox({0.3, 0.3, 0.3}, at(0.4, 0.4, 0.15), kRed);
  builder.addBody("ball", at(0, 0, 0.1));
  builder.add(builder.addMesh(sphereMesh(0.1F, 16)), Pose3::Identity(), kOrange);
  builder.addBody("rod", turned(at(-0.3, 0.4, 0.3), 0.7, Vector3d(1, 1, 0).normalized()));
  builder.add(builder.addMesh(capsuleMesh(0.05F, 0.4F, 16)), Pose3::Identity(), kSkyblue);
  builder.addBody("can", turned(at(0.1, -0.5, 0.2), 0.4, Vector3d::UnitX()));
  builder.add(builder.addMesh(cylinderMesh(0.1F, 0.3F)), at(0, 0.02, 0), kYellow);
  builder.addBody("shell", at(-0.8, -0.2, 0.2));
  builder.addBox({0.4, 0.4, 0.4}, Pose3::Identity(), kPink);
  return builder.take({lookAt({1.5, 1.0, 0.8}, {0, 0, 0.1}), lookAt({-1.4, 0.6, 0.3}, {0.2, 0, 0.1}),
                       lookAt({0.3, -0.2, 2.5}, {0, 0, 0}), lookAt({0.104, 0.002, 0.1}, {-1, 0, 0.12}),
                       lookAt({-0.8, -0.2, 0.2}, {0.5, 0.1, 0.15}), lookAt({0.9, -0.8, 0.03}, {0, 0, 0.05})});
}

}  // namespace simcore::test
