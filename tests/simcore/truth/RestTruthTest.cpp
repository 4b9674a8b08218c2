// SPDX-License-Identifier: GPL-3.0-or-later
// What rests stays where it is for a minute.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

constexpr double kMinute = 60;

/// The largest ways and turns of all bodies between a moment after the start and a minute later.
struct Drift {
  double way = 0, turn = 0;
  /// The body that went farthest.
  std::string body = {};
  /// The largest speed of a model in the last second, m/s.
  double jitter = 0;
};
double fastest(const Simulation& simulation) {
  double largest = 0;
  for (const Port& port : simulation.ports()) {
    if (port.kind != Port::Kind::kTrueVelocity) continue;
    const auto velocity = simulation.read(port.info.path).value();
    largest = largerOf(largest, Vector3(velocity[0], velocity[1], velocity[2]).norm());
  }
  return largest;
}
Drift driftOf(Simulation& simulation) {
  advance(simulation, 2);
  const std::vector<Pose3> start(simulation.bodyPoses().begin(), simulation.bodyPoses().end());
  advance(simulation, kMinute - 1);
  Drift drift;
  for (int i = 0; i < 250; ++i) {
    simulation.step();
    drift.jitter = largerOf(drift.jitter, fastest(simulation));
  }
  const auto end = simulation.bodyPoses();
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double way = (end[i].translation() - start[i].translation()).norm();
    if (way > drift.way) drift.body = simulation.renderScene()->bodies[i];
    drift.way = largerOf(drift.way, way);
    drift.turn =
        largerOf(drift.turn, Eigen::AngleAxisd(start[i].linear().transpose() * end[i].linear()).angle());
  }
  return drift;
}

std::string restingBox(const std::string& name, const std::string& pose, const Vector3& size, double mass) {
  return model(name, pose, inertial(mass, momentsOfBox(mass, size)) + solid(box(size)));
}

TEST(RestTruth, boxesCylindersAndBallsStayForAMinute) {
  const double radius = 0.1;
  const auto simulation = simulationOf(
      ground() + restingBox("flat", "0 0 0.05 0 0 0.3", {0.4, 0.3, 0.1}, 2) +
      restingBox("tall", "2 0 0.25 0 0 1", {0.1, 0.1, 0.5}, 2) +
      restingBox("heavy", "4 0 0.5 0 0 0", {1, 1, 1}, 500) +
      restingBox("light", "6 0 0.01 0 0 0", {0.02, 0.02, 0.02}, 0.005) +
      model("can", "8 0 0.15 0 0 0",
            inertial(1, momentsOfCylinder(1, radius, 0.3)) + solid(cylinder(radius, 0.3))) +
      model("ball", "10 0 0.1 0 0 0", inertial(1, momentsOfSphere(1, radius)) + solid(sphere(radius))));
  const Drift drift = driftOf(*simulation);
  SCOPED_TRACE(drift.body);
  compare({"boxes, a can and a ball, way in a minute", "0", 0, 0.001, "m"}, drift.way);
  compare({"boxes, a can and a ball, turn in a minute", "0", 0, 0.001, "rad"}, drift.turn);
  compare({"boxes, a can and a ball, largest speed at rest", "0", 0, 0.02, "m/s"}, drift.jitter);
}

TEST(RestTruth, whatIsComputedWhileItRestsStaysToo) {
  const auto simulation = simulationOf("<robotcontrol:sleeping>false</robotcontrol:sleeping>" + ground() +
                                       restingBox("flat", "0 0 0.05 0 0 0.3", {0.4, 0.3, 0.1}, 2) +
                                       restingBox("tall", "2 0 0.25 0 0 1", {0.1, 0.1, 0.5}, 2) +
                                       restingBox("heavy", "4 0 0.5 0 0 0", {1, 1, 1}, 500));
  const Drift drift = driftOf(*simulation);
  SCOPED_TRACE(drift.body);
  compare({"boxes that do not sleep, way in a minute", "0", 0, 0.001, "m"}, drift.way);
  compare({"boxes that do not sleep, turn in a minute", "0", 0, 0.001, "rad"}, drift.turn);
}

TEST(RestTruth, aStackStandsForAMinute) {
  std::string stack = ground();
  for (int i = 0; i < 5; ++i)
    stack += restingBox("box" + std::to_string(i), "0 0 " + std::to_string(0.05 + 0.1 * i) + " 0 0 0",
                        {0.2, 0.2, 0.1}, 1);
  const auto simulation = simulationOf(stack);
  const Drift drift = driftOf(*simulation);
  SCOPED_TRACE(drift.body);
  compare({"stack of five boxes, way in a minute", "0", 0, 0.02, "m"}, drift.way);
  compare({"stack of five boxes, turn in a minute", "0", 0, 0.01, "rad"}, drift.turn);
  compare({"stack of five boxes, largest speed at rest", "0", 0, 0.02, "m/s"}, drift.jitter);
}

TEST(RestTruth, robotsOfTheShippedScenesStandForAMinute) {
  for (const auto& [file, name, turning] :
       {std::tuple{"field2002.sdf", "ERS-210 on its field, way in a minute",
                   "ERS-210 on its field, turn in a minute"},
        std::tuple{"pioneer.sdf", "Pioneer in its room, way in a minute",
                   "Pioneer in its room, turn in a minute"}}) {
    const auto scene = Scene::load(std::string(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/") + file);
    ASSERT_TRUE(scene);
    const auto simulation = Simulation::create(*scene, {.seed = 1, .noise = false});
    ASSERT_TRUE(simulation);
    const Drift drift = driftOf(**simulation);
    SCOPED_TRACE(drift.body);
    compare({name, "0", 0, 0.001, "m"}, drift.way);
    compare({turning, "0", 0, 0.001, "rad"}, drift.turn);
  }
}

}  // namespace
}  // namespace simcore::truth
