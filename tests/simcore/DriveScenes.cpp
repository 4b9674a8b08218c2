// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/DriveScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "tests/simcore/SceneFixture.h"

namespace simcore {

std::string pioneerAt(const std::string& name, double x, double y, double heading) {
  std::ostringstream text;
  text << "<include><uri>model://p3at</uri><name>" << name << "</name><pose>" << x << ' ' << y << " 0 0 0 "
       << heading << "</pose></include>";
  return text.str();
}

std::string boxAt(const std::string& name, const robotlink::Vector3& center, const robotlink::Vector3& size,
                  double pitch) {
  std::ostringstream text;
  text << "<model name=\"" << name << "\"><static>true</static><pose>" << center.transpose() << " 0 " << pitch
       << " 0</pose><link name=\"box\"><collision name=\"box\"><geometry><box><size>" << size.transpose()
       << "</size></box></geometry></collision></link></model>";
  return text.str();
}

std::string wallAhead() {
  return boxAt("wall", {1.5, 0, 0.5}, {0.1, 4, 1});
}

std::string piecesAt(double x, double y0, double y1, int count) {
  std::ostringstream text;
  const double width = (y1 - y0) / count;
  text << "<model name=\"pieces\"><static>true</static><link name=\"pieces\">";
  for (int i = 0; i < count; ++i) {
    text << "<collision name=\"piece" << i << "\"><pose>" << x << ' ' << y0 + (i + 0.5) * width
         << " 0.5 0 0 0</pose><geometry><box><size>0.1 " << width << " 1</size></box></geometry></collision>";
  }
  text << "</link></model>";
  return text.str();
}

std::shared_ptr<const Scene> floorWith(const std::string& contents) {
  // Reading one takes longer than most of what is done in it.
  static std::map<std::string, std::shared_ptr<const Scene>> scenes;
  std::shared_ptr<const Scene>& known = scenes[contents];
  if (known) return known;
  const SceneFolder folder;
  const std::string floor =
      "<model name=\"floor\"><static>true</static><link name=\"floor\"><collision "
      "name=\"floor\"><geometry><plane>"
      "<normal>0 0 1</normal><size>9 9</size></plane></geometry></collision></link></model>";
  const auto scene = Scene::load(folder.write("world.sdf", worldAround(floor + contents)));
  EXPECT_TRUE(scene) << describe(scene.error());
  if (scene) known = *scene;
  return known;
}

DrivenWorld::DrivenWorld(const std::string& contents, SimulationOptions options)
    : simulation_(std::move(Simulation::create(floorWith(contents), options).value())) {}

void DrivenWorld::drive(double left, double right, double seconds, std::size_t robot) {
  constexpr double kChange = 0.3 * 0.004;
  for (int i = 0; i < static_cast<int>(seconds / 0.004); ++i) {
    left_ += std::clamp(left - left_, -kChange, kChange);
    right_ += std::clamp(right - right_, -kChange, kChange);
    simulation_->requestWheelSpeeds(robot, left_, right_);
    simulation_->step();
  }
}

void DrivenWorld::jerk(double left, double right, double seconds, std::size_t robot) {
  left_ = left;
  right_ = right;
  simulation_->requestWheelSpeeds(robot, left, right);
  for (int i = 0; i < static_cast<int>(seconds / 0.004); ++i) simulation_->step();
}

robotlink::Pose2 DrivenWorld::pose(const std::string& robot) {
  return robotlink::groundPose(*simulation_->modelPose(robot));
}

double DrivenWorld::reading(const std::string& path, std::size_t axis) {
  const auto sensors = simulation_->sensors();
  const auto found = std::ranges::find(sensors, path, [](const Sensor& sensor) { return sensor.info.path; });
  EXPECT_NE(found, sensors.end()) << path;
  return found == sensors.end() ? 0 : found->values[axis];
}

}  // namespace simcore
