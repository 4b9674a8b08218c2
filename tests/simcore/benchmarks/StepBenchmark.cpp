// SPDX-License-Identifier: GPL-3.0-or-later
// What steps of another length would cost, and how exact they would be: whether models should have steps of
// their own.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/physics/Contacts.h"
#include "simcore/physics/OdeWorld.h"
#include "simcore/physics/Physics.h"
#include "simcore/physics/threads/OdeRandom.h"
#include "tests/simcore/SceneFixture.h"

namespace {

using namespace simcore;

constexpr int kRobots = 8;
constexpr double kSlice = 0.2;  // s
/// The share of the missing angle by which a servo turns in a step; see Actuation.
constexpr double kGain = 0.4;

std::shared_ptr<const Scene> walkingRobots() {
  const SceneFolder folder;
  folder.copyShippedModels();
  std::string contents = "<include><uri>model://field2002</uri></include>";
  for (int i = 0; i < kRobots; ++i)
    contents += "<include><uri>model://ers210</uri><name>red" + std::to_string(i + 1) + "</name><pose>" +
                std::to_string(-1.8 + 0.45 * i) + " 0.7 0.1138 0 0 0</pose></include>";
  return Scene::load(folder.write("world.sdf", worldAround(contents))).value();
}

/// The servos of all robots: their hinges, and what they are asked for.
struct SwingingServo {
  std::size_t hinge = 0;
  double stance = 0, torque = 0, speed = 0;
  double target(double time) const { return stance + 0.15 * std::sin(8 * time + static_cast<double>(hinge)); }
};

std::vector<SwingingServo> servosOf(const WorldDescription& world) {
  std::vector<SwingingServo> servos;
  std::size_t hinge = 0;
  for (const ModelInstance& instance : world.models) {
    if (instance.type->isStatic) continue;
    for (const JointDescription& joint : instance.type->joints) {
      if (joint.kind != JointDescription::Kind::kHinge && joint.kind != JointDescription::Kind::kSlider)
        continue;
      if (joint.servo) servos.push_back({hinge, joint.initialAngle, joint.maximumTorque, joint.maximumSpeed});
      ++hinge;
    }
  }
  return servos;
}

/// A step of any length, as Physics makes those of its own.
void stepBy(OdeWorld& ode, double seconds, std::uint64_t seed) {
  seedOdeRandom(seed);
  for (OdeGeom* geom : ode.touchedGeoms) geom->touched = false;
  ode.touchedGeoms.clear();
  ode.touches.clear();
  ode.obstacleBodies.clear();
  ode.contactCount = 0;
  findContacts(ode);
  dWorldQuickStep(ode.world, seconds);
  dJointGroupEmpty(ode.contacts);
}

void stepsOfLength(benchmark::State& state) {
  const double length = static_cast<double>(state.range(0)) / 1000;
  const auto scene = walkingRobots();
  Physics physics(scene->contents().world);
  OdeWorld& ode = physics.ode();
  dWorldSetQuickStepNumIterations(ode.world, static_cast<int>(state.range(1)));
  const std::vector<SwingingServo> servos = servosOf(scene->contents().world);
  double gap = 0, error = 0, lowest = 1, took = 0, samples = 0, time = 0;
  std::uint64_t step = 0;
  for ([[maybe_unused]] const auto _ : state) {
    for (double slice = 0; slice < kSlice - 1e-9; slice += length, time += length) {
      const auto begin = std::chrono::steady_clock::now();
      for (const SwingingServo& servo : servos) {
        const double missing = servo.target(time) - physics.angle(servo.hinge);
        error += std::abs(missing);
        ++samples;
        physics.setMotor(servo.hinge, std::clamp(kGain * missing / length, -servo.speed, servo.speed),
                         servo.torque);
      }
      stepBy(ode, length, ++step);
      took += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      for (const SwingingServo& servo : servos) gap = std::max(gap, physics.anchorGap(servo.hinge));
    }
    for (int model = 0; model < static_cast<int>(ode.models.size()); ++model)
      if (ode.models[static_cast<std::size_t>(model)].bodyCount > 0)
        lowest = std::min(lowest, physics.modelInWorld(model).translation().z());
  }
  state.counters["times_real"] = time / took;
  state.counters["gap_mm"] = 1000 * gap;
  state.counters["servo_error_mrad"] = 1000 * error / samples;
  state.counters["lowest_mm"] = 1000 * lowest;
}
BENCHMARK(stepsOfLength)
    ->ArgNames({"ms", "iterations"})
    ->ArgsProduct({{2, 4, 8}, {10, 20, 30, 40, 50}})
    ->Iterations(50)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
