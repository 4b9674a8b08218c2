// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors of distances, depth and radiation against geometry.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

using robotlink::kPi;

/// A static box that is solid and drawn.
std::string wall(const std::string& name, const std::string& pose, const Vector3& size,
                 const std::string& inVisual = "") {
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='l'><collision name='c'>" + box(size) + "</collision><visual name='v'>" +
         box(size) + inVisual + "</visual></link></model>";
}

/// A body that hangs weightless in the air and carries sensors.
std::string probe(const std::string& sensors, const std::string& pose = "0 0 1 0 0 0") {
  return "<gravity>0 0 0</gravity>" + model("probe", pose, inertial(1, Vector3::Constant(0.1)) + sensors);
}

std::string lidar(const std::string& name, int samples, double from, double to, double farthest,
                  const std::string& type = "lidar") {
  return fmt::format(
      "<sensor name='{}' type='{}'><lidar><scan><horizontal><samples>{}</samples><min_angle>{}</min_angle>"
      "<max_angle>{}</max_angle></horizontal></scan><range><min>0.02</min><max>{}</max></range></lidar></"
      "sensor>",
      name, type, samples, from, to, farthest);
}

std::string sonar(double radius, double farthest) {
  return fmt::format(
      "<sensor name='sonar' "
      "type='sonar'><sonar><min>0.1</min><max>{}</max><radius>{}</radius></sonar></sensor>",
      farthest, radius);
}

std::vector<double> scan(const Simulation& simulation) {
  std::vector<double> ranges(static_cast<std::size_t>(simulation.rangeSensors()[0].readings));
  simulation.measure(0, ranges);
  return ranges;
}

TEST(RangeTruth, aLaserMeasuresARoomAsGeometrySays) {
  // The walls' inner sides are at x = -2 and 3, y = -1.5 and 2.5; a post of 0.2 m radius stands at (1, 1).
  const std::string post =
      "<model name='post'><static>true</static><pose>1 1 1 0 0 0</pose><link name='l'><visual name='v'>" +
      cylinder(0.2, 2) + "</visual></link></model>";
  const double heading = 0.4;
  const auto simulation = simulationOf(
      wall("east", "3.1 0.5 1 0 0 0", {0.2, 8, 2}) + wall("west", "-2.1 0.5 1 0 0 0", {0.2, 8, 2}) +
      wall("north", "0.5 2.6 1 0 0 0", {8, 0.2, 2}) + wall("south", "0.5 -1.6 1 0 0 0", {8, 0.2, 2}) + post +
      probe(lidar("laser", 361, -kPi, kPi, 20), "0 0 1 0 0 0.4"));
  const auto ranges = scan(*simulation);
  double largest = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double angle = -kPi + 2 * kPi * static_cast<double>(i) / 360 + heading;
    const double c = std::cos(angle), s = std::sin(angle);
    double expected = std::min(c > 0 ? 3 / c : -2 / c, s > 0 ? 2.5 / s : -1.5 / s);
    // The post: |t d - p| = r.
    const double along = c + s, square = along * along - (2 - 0.04);
    const double off = std::abs(c - s);
    // The drawn post has 24 sides, whose middles are r (1 - cos(pi / 24)) inside; its edge is left out.
    if (off > 0.19 && off < 0.21) continue;
    if (along > 0 && off < 0.2) expected = std::min(expected, along - std::sqrt(square));
    largest = largerOf(
        largest,
        std::abs(ranges[i] - expected) -
            (along > 0 && off < 0.2 ? 0.2 * (1 - std::cos(kPi / 24)) / std::sqrt(1 - off * off / 0.04) : 0));
  }
  compare({"laser, 361 rays in a room with a post", "rays cut planes and a circle", 0, 1e-4, "m"},
          largerOf(0.0, largest));
}

TEST(RangeTruth, aSonarHearsTheNearestOfItsCone) {
  // Its cone has a half angle of atan(0.5 / 2).
  const double half = std::atan(0.25);
  for (const double turn : {0.0, 0.1, 0.2, 0.5}) {
    const auto simulation = simulationOf(wall("wall", "1.6 0 1 0 0 0", {0.2, 10, 2}) +
                                         probe(sonar(0.5, 2), fmt::format("0 0 1 0 0 {}", turn)));
    // The nearest point of the wall that is in the cone; rays are 1.5 degrees apart.
    const double off = std::max(0.0, turn - half);
    compare({"sonar before a wall at several angles", "d / cos(angle of the cone's edge to the normal)",
             1.5 / std::cos(off), 0.03, "m"},
            scan(*simulation)[0]);
  }
  const auto reflected =
      simulationOf(wall("wall", "1.6 0 1 0 0 0", {0.2, 10, 2}) + probe(sonar(0.5, 4), "0 0 1 0 0 1.3"));
  compare({"sonar, incidence beyond 55 degrees", "no echo", 4, 1e-9, "m"}, scan(*reflected)[0]);
  // A thin post is heard within the cone and not beyond it.
  for (const auto& [angle, heard] : {std::pair{half - 0.02, true}, std::pair{half + 0.05, false}}) {
    const auto simulation =
        simulationOf(wall("post", fmt::format("{} {} 1 0 0 {}", std::cos(angle), std::sin(angle), angle),
                          {0.06, 0.06, 2}) +
                     probe(sonar(0.5, 2)));
    compare({"sonar, post at the edge of its cone", "heard within the half angle only", heard ? 0.97 : 2,
             0.01, "m"},
            scan(*simulation)[0]);
  }
}

TEST(RangeTruth, aDistanceSensorMeasuresAlongItsRay) {
  for (const double turn : {0.0, 0.3, -0.7}) {
    const auto simulation =
        simulationOf(wall("wall", "1.6 0 1 0 0 0", {0.2, 10, 4}) +
                     probe(lidar("psd", 1, 0, 0, 5), fmt::format("0 0 1 0 {} {}", turn, turn)));
    compare({"distance sensor of one ray", "d / (cos pitch cos yaw)", 1.5 / (std::cos(turn) * std::cos(turn)),
             1e-9, "m"},
            read(*simulation, "probe/psd"));
  }
  const auto reads = [](double length) {
    const auto simulation =
        simulationOf(wall("wall", "1.6 0 1 0 0 0", {0.2, 10, 4}) +
                     probe(customSensor(
                         "whisker", fmt::format("<robotcontrol:whisker>{}</robotcontrol:whisker>", length))));
    return read(*simulation, "probe/whisker");
  };
  compare({"whisker of 1 mm less than the distance", "does not touch", 0, 0, ""}, reads(1.499));
  compare({"whisker of 1 mm more than the distance", "touches", 1, 0, ""}, reads(1.501));
}

std::string depthCamera(int width, int height, double angle) {
  return fmt::format(
      "<sensor name='eye' "
      "type='depth_camera'><camera><horizontal_fov>{}</horizontal_fov><image><width>{}</width>"
      "<height>{}</height></image><clip><near>0.1</near><far>10</far></clip></camera></sensor>",
      angle, width, height);
}

TEST(RangeTruth, depthOfAPlaneIsThatOfItsRays) {
  // A wall 2 m ahead that is turned by 0.5 about the vertical.
  const double turn = 0.5;
  const auto simulation =
      simulationOf(wall("wall", "2 0 1 0 0 0.5", {0.001, 20, 20}) + probe(depthCamera(64, 48, 1.2)));
  std::vector<float> depth(64 * 48);
  simulation->measureImage(0, depth);
  const double focal = 32 / std::tan(0.6);
  double largest = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    // Point (d, d s, ...) with n (p - p0) = 0, n = (cos, sin).
    const double s = (32 - (static_cast<double>(i % 64) + 0.5)) / focal;
    const double expected =
        (2 - 0.0005 / std::cos(turn)) * std::cos(turn) / (std::cos(turn) + s * std::sin(turn));
    if (expected < 9.9)
      largest = largerOf(largest, std::abs(static_cast<double>(depth[i]) - expected) / expected);
  }
  compare({"depth camera, slanted plane, relative error", "n p0 / (n ray)", 0, 1e-4, ""}, largest);
}

TEST(RangeTruth, radiationFollowsItsFormula) {
  const std::string surface =
      "<robotcontrol:surface class='heat'><robotcontrol:reflects>0.4</robotcontrol:reflects>"
      "<robotcontrol:emits>3</robotcontrol:emits></robotcontrol:surface>";
  const std::string eye = customSensor(
      "eye",
      "<robotcontrol:facette><robotcontrol:class>heat</robotcontrol:class><robotcontrol:azimuth>0.4 -0.4 9"
      "</robotcontrol:azimuth><robotcontrol:elevation>0 0 1</robotcontrol:elevation></robotcontrol:facette>");
  const std::string emitter =
      "<robotcontrol:emitter><robotcontrol:position>0 1 0</robotcontrol:position>"
      "<robotcontrol:attenuation>0.5</robotcontrol:attenuation>"
      "<robotcontrol:intensity class='heat'>100</robotcontrol:intensity></robotcontrol:emitter>";
  const auto simulation = simulationOf(
      "<robotcontrol:radiation "
      "name='heat'><robotcontrol:ambient>10</robotcontrol:ambient></robotcontrol:radiation>" +
      wall("wall", "2.1 0 1 0 0 0", {0.2, 20, 20}, surface) + probe(eye + emitter));
  const ImageSensor& sensor = simulation->imageSensors()[0];
  std::vector<float> values(sensor.values());
  simulation->measureImage(0, values);
  ASSERT_EQ(values.size(), 9U);
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double y = 2 * std::tan(0.4 - 0.1 * static_cast<double>(i));
    const double square = 4 + (y - 1) * (y - 1), cosine = 2 / std::sqrt(square);
    const double expected = 3 + 0.4 * (10 + 100 / (1 + 0.5 * square) * cosine);
    largest = largerOf(largest, std::abs(static_cast<double>(values[i]) - expected) / expected);
  }
  compare({"facettes that sense radiation, relative error",
           "emits + reflects (ambient + I / (1 + a d^2) cos)", 0, 0.001, ""},
          largest);
}

}  // namespace
}  // namespace simcore::truth
