// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/ArcosOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/NumberRange.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ShippedFiles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "app/robotctl/run/SimFigures.h"
#include "simcore/Scene.h"
#include "simcore/SceneFileKind.h"

namespace app {

void ArcosOptions::addTo(CLI::App& command) {
  command.add_option(
      "--robot", robot,
      "The model of the robots that --robots adds, a folder of resources/scenes/models: ers210, p3at, "
      "burger (those of the scene, if it has any; else p3at)");
  robots_ = command.add_option("--robots", robots, "How many robots to add to the scene (to a map: 1)")
                ->check(numberFrom(0, 1000));
  teams_ = command.add_option("--teams", teams, "The teams of added robots that play: both, red or blue")
               ->check(CLI::IsMember({"both", "red", "blue"}))
               ->capture_default_str();
  arcos_ =
      command
          .add_option(
              "--arcos", port,
              "Lets external programs drive the robots over ARCOS: the first at this TCP port "
              "(8101), the others at the ports after it; runs in real time, without the robots' own programs")
          ->expected(0, 1)
          ->default_str("8101");
  command
      .add_option("--bind", address,
                  "The address of these ports; addresses other than loopback open them to the network")
      ->needs(arcos_)
      ->capture_default_str();
  command.add_flag("--kinematic", kinematic,
                   "Robots on wheels are moved by their odometry instead of by forces");
  command
      .add_flag("--all-sonars", allSonars,
                "Each information packet has the readings of all sonars, which otherwise fire in turn")
      ->needs(arcos_);
}

bool ArcosOptions::given() const {
  return arcos_ != nullptr && arcos_->count() > 0;
}

robotlink::Result<void> ArcosOptions::check(const std::filesystem::path& scene) const {
  const bool namesTeams = teams_ != nullptr && teams_->count() > 0;
  if (robotsFor(scene, 0).count > 0 || (robot.empty() && !namesTeams)) return {};
  return robotlink::failure("usage", std::string(namesTeams ? "--teams" : "--robot") +
                                         " is for robots that are added; say how many with --robots");
}

simcore::RobotsToAdd ArcosOptions::robotsFor(const std::filesystem::path& scene, std::uint64_t seed) const {
  const bool asked = robots_ != nullptr && robots_->count() > 0;
  simcore::RobotsToAdd add;
  // Only Pioneers speak ARCOS.
  add.model = robot.empty() && given() ? simcore::RobotsToAdd{}.model : robot;
  add.count = asked ? robots : simcore::isMapFile(scene) ? 1 : 0;
  add.seed = seed;
  add.teams = teamsNamed(teams);
  return add;
}

void ArcosOptions::applyTo(RunOptions& run) const {
  run.robots = robotsFor(run.scene, run.world.seed);
  run.world.kinematic = kinematic;
}

int runArcos(const ArcosOptions& options, const ArcosRun& run) {
  ArcosSimulation::Options wanted;
  wanted.scene = run.scene;
  wanted.models = run.models;
  wanted.robots = options.robotsFor(run.scene, run.world.seed);
  wanted.world = run.world;
  wanted.world.kinematic = options.kinematic;
  wanted.world.pioneers.settings.allSonarsEachCycle = options.allSonars;
  wanted.ports = {options.address, options.port};
  wanted.speed = run.speed;
  TerminalProgress progress;
  wanted.progress = progress.function();
  auto simulation =
      ArcosSimulation::create(wanted, [](const std::string& text) { std::cerr << text << std::endl; });
  progress.erase();
  if (!simulation) return printErrors(simulation.error());
  printMapNotes(std::cerr, (*simulation)->world().simulation().scene().groundMap().get());
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
  const nlohmann::json figures = figuresOf(**simulation, real);
  std::cout << (run.asJson ? jsonOutput(figures) : figuresText(figures));
  return ports.exitRequest().value_or(0) == 0 ? kDone : kFailed;
}

}  // namespace app
