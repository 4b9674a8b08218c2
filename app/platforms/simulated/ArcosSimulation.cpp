// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/ArcosSimulation.h"

#include <algorithm>
#include <utility>

namespace app {

using Clock = std::chrono::steady_clock;

/// A slow simulation asks at least this often whether to stop.
constexpr std::chrono::milliseconds kAskEvery{100};

tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> ArcosSimulation::create(
    Options options, ArcosPorts::Log logger) {
  auto scene = simcore::Scene::load(options.scene, options.robots, std::exchange(options.progress, {}),
                                    options.models);
  if (!scene) return tl::unexpected(scene.error());
  return create(std::move(*scene), std::move(options), std::move(logger));
}

tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> ArcosSimulation::create(
    std::shared_ptr<const simcore::Scene> scene, Options options, ArcosPorts::Log logger) {
  std::unique_ptr<ArcosSimulation> simulation(new ArcosSimulation(std::move(options)));
  auto world = SimulatedWorld::create(std::move(scene), simulation->options_.world);
  if (!world) return tl::unexpected(robotlink::Errors{world.error()});
  simulation->world_ = std::move(*world);
  auto ports = ArcosPorts::open(*simulation->world_, simulation->options_.ports, std::move(logger));
  if (!ports) return tl::unexpected(robotlink::Errors{ports.error()});
  simulation->ports_ = std::move(*ports);
  simulation->pace_.setSpeed(simulation->options_.speed);
  return simulation;
}

bool ArcosSimulation::serveUntilDue(const std::function<bool()>& stop) {
  const auto due = pace_.due(world_->clock().now());
  for (auto now = Clock::now(); now + kAskEvery < due; now = Clock::now()) {
    ports_->serve(now + kAskEvery);
    if (stop && stop()) return false;
  }
  ports_->serve(due);
  return true;
}

void ArcosSimulation::step() {
  (void)stepUnless({});
}

bool ArcosSimulation::stepUnless(const std::function<bool()>& stop) {
  const auto time = world_->clock().now();
  if (!std::exchange(paced_, true)) pace_.restart(Clock::now(), time);
  if (options_.speed > 0) {
    if (!serveUntilDue(stop)) return false;
    keepTime(Clock::now(), time);
  } else {
    ports_->serve(Clock::now());
  }
  world_->advance();
  ports_->deliver();
  return true;
}

void ArcosSimulation::keepTime(Clock::time_point now, robotlink::Instant time) {
  const robotlink::Duration late = now - pace_.due(time);
  punctuality_.latest = std::max(punctuality_.latest, late);
  if (late > Pace::kMaxLag) punctuality_.lost += late;
  pace_.forgetLag(now, time);
}

void ArcosSimulation::run(robotlink::Instant end, const std::function<bool()>& stop) {
  while (world_->clock().now() < end && !ports_->exitRequest() && !(stop && stop()) && stepUnless(stop)) {
  }
}

}  // namespace app
