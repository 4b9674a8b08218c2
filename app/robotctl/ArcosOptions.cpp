// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/ArcosOptions.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/robotctl/Commands.h"
#include "app/robotctl/ContactFigures.h"
#include "app/robotctl/Interrupt.h"

namespace app {
namespace {

using nlohmann::json;

json robotFigures(const ArcosSimulation& simulation, std::size_t index) {
  const auto line = simulation.ports().ports().statistics(index);
  json figures = contactFigures(simulation.world(), simulation.world().pioneers()[index]->robot());
  figures["url"] = simulation.ports().url(index);
  figures["clients"] = line.clients;
  figures["refused_clients"] = line.refused;
  figures["packets_received"] = line.received.packets;
  figures["checksum_errors"] = line.received.checksumErrors;
  figures["skipped_bytes"] = line.received.skippedBytes;
  figures["packets_sent"] = line.sentPackets;
  figures["packets_dropped"] = line.droppedPackets;
  return figures;
}

json figuresOf(const ArcosSimulation& simulation, double realSeconds) {
  const SimulatedWorld& world = simulation.world();
  const auto& costs = world.costs();
  const double simulated = robotlink::seconds(world.clock().now());
  const double steps = std::max<double>(1, static_cast<double>(costs.steps));
  json figures;
  figures["scene"] = simulation.options().scene.string();
  figures["seed"] = world.options().seed;
  figures["kinematic"] = world.options().kinematic;
  figures["simulated_seconds"] = simulated;
  figures["real_seconds"] = realSeconds;
  figures["real_time_factor"] = realSeconds > 0 ? simulated / realSeconds : 0;
  figures["steps"] = costs.steps;
  figures["ms_per_step"] = robotlink::seconds(costs.physics) * 1000 / steps;
  figures["ms_per_step_of_controllers"] = robotlink::seconds(costs.pioneers) * 1000 / steps;
  figures["latest_step_seconds"] = robotlink::seconds(simulation.punctuality().latest);
  figures["real_time_lost_seconds"] = robotlink::seconds(simulation.punctuality().lost);
  std::uint64_t contacts = 0;
  for (std::size_t i = 0; i < world.pioneers().size(); ++i) {
    figures["robots"].push_back(robotFigures(simulation, i));
    contacts += figures["robots"].back()["contacts"].get<std::uint64_t>();
  }
  figures["contacts"] = contacts;
  return figures;
}

void printFigures(const json& figures) {
  for (const auto& [name, value] : figures.items()) {
    if (value.is_array()) continue;
    std::cout << std::left << std::setw(28) << name
              << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
  }
  for (const auto& robot : figures["robots"]) {
    std::cout << robot["name"].get<std::string>() << ": touched something " << robot["contacts"]
              << " times for " << robot["contact_seconds"] << " s altogether, " << robot["clients"]
              << " clients\n";
  }
}

}  // namespace

void ArcosOptions::addTo(CLI::App& command) {
  command.add_option("--robot", robot, "The model of the robots that --robots adds")->capture_default_str();
  robots_ = command.add_option("--robots", robots, "How many robots to add to the scene (to a map: 1)")
                ->check(CLI::Range(0, 1000));
  arcos_ =
      command
          .add_option(
              "--arcos", port,
              "Opens the robots to programs by ARCOS: the first at this TCP port (8101), the next at the "
              "next; runs in real time, without programs of its own")
          ->expected(0, 1)
          ->default_str("8101");
  command
      .add_option("--bind", address,
                  "The address to open them at; others than loopback open them to the network")
      ->needs(arcos_)
      ->capture_default_str();
  command.add_flag("--kinematic", kinematic,
                   "Robots on wheels are moved by their odometry instead of by forces");
  command
      .add_flag("--all-sonars", allSonars,
                "Sonars all come with each information packet, instead of firing in turn")
      ->needs(arcos_);
}

bool ArcosOptions::given() const {
  return arcos_ != nullptr && arcos_->count() > 0;
}

simcore::RobotsToAdd ArcosOptions::robotsFor(const std::filesystem::path& scene, std::uint64_t seed) const {
  const bool asked = robots_ != nullptr && robots_->count() > 0;
  simcore::RobotsToAdd add;
  add.model = robot;
  add.count = asked ? robots : scene.extension() == ".map" ? 1 : 0;
  add.seed = seed;
  return add;
}

void ArcosOptions::applyTo(RunOptions& run) const {
  run.robots = robotsFor(run.scene, run.world.seed);
  run.world.kinematic = kinematic;
}

int runArcos(const ArcosOptions& options, const ArcosRun& run) {
  ArcosSimulation::Options wanted;
  wanted.scene = run.scene;
  wanted.robots = options.robotsFor(run.scene, run.world.seed);
  wanted.world = run.world;
  wanted.world.kinematic = options.kinematic;
  wanted.world.pioneers.settings.allSonarsEachCycle = options.allSonars;
  wanted.ports = {options.address, options.port};
  wanted.speed = run.speed;
  auto simulation =
      ArcosSimulation::create(wanted, [](const std::string& text) { std::cerr << text << std::endl; });
  if (!simulation) return printErrors(simulation.error());
  const ArcosPorts& ports = (*simulation)->ports();
  if (const std::string warning = ports.warning(); !warning.empty())
    std::cerr << "Warning: " << warning << "\n";
  for (std::size_t i = 0; i < (*simulation)->world().pioneers().size(); ++i) {
    std::cerr << (*simulation)->world().pioneers()[i]->robot() << " listens at " << ports.url(i) << std::endl;
  }
  const Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  const auto end =
      run.seconds ? robotlink::Instant(robotlink::fromSeconds(*run.seconds)) : robotlink::Instant::max();
  (*simulation)->run(end, &Interrupt::noted);
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const json figures = figuresOf(**simulation, real);
  if (run.asJson) {
    std::cout << figures.dump(2) << "\n";
  } else {
    printFigures(figures);
  }
  return ports.exitRequest().value_or(0) == 0 ? kDone : kFailed;
}

}  // namespace app
