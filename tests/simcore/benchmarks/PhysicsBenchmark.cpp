// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "simcore/devices/Ports.h"
#include "simcore/physics/OdeWorldBuilder.h"
#include "tests/simcore/SceneFixture.h"

// A step of the field with one robot through simcore, against the same world stepped by bare ODE calls in
// turns with it; the aim is a ratio under 1.15. Both servo the same stance. Times are those of the thread's
// processor time, so others on the machine do not count.
namespace {

using namespace simcore;

double threadMicroseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) * 1e-3;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

/// The least that such a world needs: collide, contact joints, set-points, step.
class BareWorld {
 public:
  explicit BareWorld(const Scene& scene) : ode_(buildOdeWorld(scene.contents().world)) {
    for (const dJointID hinge : ode_->hinges) targets_.push_back(dJointGetHingeAngle(hinge));
  }

  void step() {
    for (std::size_t i = 0; i < ode_->hinges.size(); ++i) {
      const double missing = targets_[i] - dJointGetHingeAngle(ode_->hinges[i]);
      dJointSetHingeParam(ode_->hinges[i], dParamVel, std::clamp(0.4 * missing / 0.004, -2.8, 2.8));
      dJointSetHingeParam(ode_->hinges[i], dParamFMax, 1);
    }
    dSpaceCollide(ode_->top, ode_.get(), &BareWorld::collide);
    dWorldQuickStep(ode_->world, 0.004);
    dJointGroupEmpty(ode_->contacts);
  }

 private:
  static void collide(void* data, dGeomID a, dGeomID b) {
    auto& ode = *static_cast<OdeWorld*>(data);
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) return dSpaceCollide2(a, b, data, &BareWorld::collide);
    dContact contacts[4];
    const int count = dCollide(a, b, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
      contacts[i].surface.mu = 1;
      contacts[i].surface.soft_erp = 0.3;
      contacts[i].surface.soft_cfm = 1e-5;
      dJointAttach(dJointCreateContact(ode.world, ode.contacts, &contacts[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  std::unique_ptr<OdeWorld> ode_;
  std::vector<double> targets_;
};

void stepAgainstBareOde(benchmark::State& state) {
  constexpr int kBatch = 50;
  const auto scene = shippedScene();
  BareWorld bare(*scene);
  const auto simulation = std::move(Simulation::create(scene, {}).value());
  std::vector<double> ours, theirs;
  const auto measure = [](std::vector<double>& times, const std::function<void()>& run) {
    const double start = threadMicroseconds();
    for (int i = 0; i < kBatch; ++i) run();
    times.push_back((threadMicroseconds() - start) / kBatch);
  };
  const bool sensors = state.range(0) != 0;
  for ([[maybe_unused]] const auto _ : state) {
    measure(ours, [&] {
      simulation->step();
      // A robot's frame is two steps.
      if (sensors && simulation->steps() % 2 == 0) benchmark::DoNotOptimize(simulation->sensors().data());
    });
    measure(theirs, [&] { bare.step(); });
  }
  state.counters["ours_us"] = median(ours);
  state.counters["ode_us"] = median(theirs);
  state.counters["ratio"] = median(ours) / median(theirs);
}
BENCHMARK(stepAgainstBareOde)->ArgName("sensors")->Arg(0)->Arg(1)->MinTime(2);

/// A world with the field, the ball and so many robots.
std::string worldWith(int robots) {
  std::string contents =
      "<include><uri>model://field2002</uri></include><include><uri>model://ball</uri><pose>0 0 0.0421 0 0 "
      "0</pose></include>";
  for (int i = 0; i < robots; ++i) {
    contents += "<include><uri>model://ers210</uri><name>red" + std::to_string(i + 1) + "</name><pose>" +
                std::to_string(-1.8 + 0.45 * i) + " 0.7 0.1138 0 0 0</pose></include>";
  }
  return worldAround(contents);
}

std::shared_ptr<const Scene> load(int robots) {
  const SceneFolder folder;
  folder.copyShippedModels();
  return Scene::load(folder.write("world.sdf", worldWith(robots))).value();
}

void loadScene(benchmark::State& state) {
  const SceneFolder folder;
  folder.copyShippedModels();
  const auto file = folder.write("world.sdf", worldWith(static_cast<int>(state.range(0))));
  for ([[maybe_unused]] const auto _ : state) benchmark::DoNotOptimize(Scene::load(file).value());
}
BENCHMARK(loadScene)->ArgName("robots")->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

void reset(benchmark::State& state) {
  const auto simulation = std::move(Simulation::create(shippedScene(), {}).value());
  for ([[maybe_unused]] const auto _ : state) simulation->reset(1);
}
BENCHMARK(reset)->Unit(benchmark::kMicrosecond);

void stepRobots(benchmark::State& state) {
  const auto simulation = std::move(Simulation::create(load(static_cast<int>(state.range(0))), {}).value());
  for ([[maybe_unused]] const auto _ : state) simulation->step();
}
BENCHMARK(stepRobots)->ArgName("robots")->Arg(1)->Arg(4)->Arg(8)->Unit(benchmark::kMicrosecond);

}  // namespace
