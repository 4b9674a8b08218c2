// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimArguments.h"

#include <CLI/CLI.hpp>

#include "app/core/platform/NumberRange.h"
#include "robotlink/base/threads/ThreadPool.h"

namespace app {
namespace {

/// The options about the scene, its robots and its time.
void addSceneOptions(CLI::App& sim, SimArguments& arguments) {
  sim.add_option("scene", arguments.run.scene,
                 "An SDFormat world, a map (*.map), or the name of a shipped one")
      ->required();
  sim.add_option("--seconds", arguments.seconds,
                 "Simulated seconds (10; with --trials 60 each; with --arcos or --listen until Ctrl-C)")
      ->check(numberFrom(0, 1e6));
  sim.add_option("--seed", arguments.run.world.seed, "Seed of all noise and of the trials' places")
      ->capture_default_str();
  arguments.teams.addTo(sim);
  sim.add_option("--models", arguments.models,
                 "Folders in which model://NAME is searched first, separated by colons")
      ->expected(1)
      ->take_all()
      ->delimiter(':')
      ->type_name("FOLDER");
  sim.add_option("--script", arguments.script,
                 "Runs a script of commands, such as simulation.step and scene.add, and ends with it; the "
                 "simulation is paused at first")
      ->check(CLI::ExistingFile);
}

/// The options about the processes of programs.
void addProgramOptions(CLI::App& sim, SimArguments& arguments) {
  sim.add_option(
         "--executor", arguments.executor,
         "How processes run: lockstep (reproducible), or threads (the simulation does not wait for them)")
      ->check(CLI::IsMember({"lockstep", "threads"}))
      ->capture_default_str();
  sim.add_option(
         "--threads", arguments.run.world.threads,
         "How many threads share physics, sensors, images and the robots' programs; the results are the "
         "same for any number (default: as many as the machine has cores)")
      ->check(numberFrom(1, robotlink::ThreadPool::kMaxThreads));
  sim.add_option("--own-process", arguments.ownProcesses,
                 "ROBOT whose program runs in its own process, so that a crash harms nothing else; "
                 "'all' for each robot")
      ->delimiter(',')
      ->type_name("ROBOT|all");
  sim.add_option("--program-memory", arguments.programMemory,
                 "How much memory a program in a process of its own may allocate, MiB; 0: no limit")
      ->check(numberFrom(0, 1 << 20))
      ->capture_default_str();
  sim.add_option("--patience", arguments.patience,
                 "Seconds after which a module that does not return is reported, and the game continues "
                 "without its robot; 0: never, or with --listen after 2 s")
      ->check(numberFrom(0, 1e6))
      ->capture_default_str();
}

/// The options about games and walks that are measured, and about the speed, which these do not have.
void addTrialOptions(CLI::App& sim, SimArguments& arguments) {
  auto* trials =
      sim.add_option(
             "--trials", arguments.trials,
             "Plays this many games with the ball at random places around the first robot; counts touches")
          ->check(numberFrom(1, 100000));
  sim.add_option("--radius", arguments.radius, "Radius of these places around the robot, m")
      ->check(numberFrom(0.4, 10))
      ->needs(trials)
      ->capture_default_str();
  sim.add_flag(
         "--goals", arguments.goals,
         "Places robot and ball of these games anywhere on the field, and counts goals within --seconds")
      ->needs(trials);
  sim.add_option(
         "--walk", arguments.walk,
         "Measures how the first robot walks when FORWARD[,LEFT[,TURN]] (m/s, degrees/s) is requested, "
         "for --seconds (5)")
      ->delimiter(',')
      ->expected(1, 3)
      ->check(numberFrom(-1000, 1000))
      ->excludes(trials);
  sim.add_option("--speed", arguments.speed,
                 "Speed relative to real time; 0 is as fast as possible (default: 0 in lockstep, 1 with "
                 "threads, --arcos or --listen)")
      ->check(numberFrom(0, 100))
      ->excludes(trials);
}

/// The options about the figures and texts that are printed.
void addOutputOptions(CLI::App& sim, SimArguments& arguments) {
  sim.add_flag("--errors", arguments.errors,
               "Adds to the figures the errors of each robot's percepts and models against the ground truth");
  sim.add_flag("--texts", arguments.texts, "Prints the programs' text messages on stderr");
  sim.add_flag("--digest", arguments.digest, "Prints only a hash of everything that happened");
  sim.add_flag("--json", arguments.asJson, "Prints figures as one JSON object");
}

/// A use of a scene, the options that do not apply to it, and the reason.
struct SimUse {
  bool isMeant;
  const char* why;
  std::vector<const char*> others;
};

}  // namespace

void SimArguments::addTo(CLI::App& sim) {
  addSceneOptions(sim, *this);
  addProgramOptions(sim, *this);
  sim.add_flag("--no-noise", noNoise, "Sensors without noise");
  sim.add_flag("--blackout", run.world.blackout, "Cameras see only black");
  addTrialOptions(sim, *this);
  sim.add_flag("--progress", progress,
               "Prints the simulated time on stderr, ten times in each simulated second");
  snapshots.addTo(sim);
  arcos.addTo(sim);
  listen.addTo(sim);
  sim.add_flag("--paused", isPaused,
               "With --listen: waits before the first step until a client starts it, so that external "
               "controllers miss none (the service control_simulation with {\"action\": \"START\"})")
      ->needs("--listen");
  camera.addTo(sim);
  record.addTo(sim);
  addOutputOptions(sim, *this);
}

robotlink::Result<void> SimArguments::check(const CLI::App& sim) const {
  const SimUse uses[]{
      {arcos.given(),
       "with --arcos robots have no programs here",
       {"--script",      "--walk",     "--trials",         "--listen",      "--layout",   "--solution",
        "--shadow",      "--preset",   "--game",           "--color-table", "--executor", "--own-process",
        "--snapshot-at", "--restore",  "--record",         "--errors",      "--texts",    "--digest",
        "--progress",    "--patience", "--labelled-images"}},
      {!script.empty(),
       "a script itself controls the run and its recording",
       {"--walk", "--trials", "--listen", "--seconds", "--speed", "--snapshot-at", "--restore", "--record",
        "--errors", "--texts", "--digest", "--json", "--progress", "--labelled-images"}},
      {!walk.empty(),
       "--walk measures how one robot walks",
       {"--listen", "--speed", "--snapshot-at", "--restore", "--record", "--errors", "--texts", "--digest",
        "--progress", "--labelled-images"}},
      {trials > 0,
       "--trials plays many games in lockstep, as fast as possible",
       {"--listen", "--executor", "--snapshot-at", "--restore", "--record", "--errors", "--texts", "--digest",
        "--progress", "--labelled-images"}},
      {listen.given(),
       "--listen is for one game in which others take part",
       {"--snapshot-at", "--restore", "--errors", "--digest", "--json", "--progress", "--labelled-images"}}};
  for (const SimUse& use : uses) {
    if (!use.isMeant) continue;
    std::string given;
    for (const char* other : use.others) {
      if (sim.get_option(other)->count() > 0) given += (given.empty() ? "" : ", ") + std::string(other);
    }
    if (!given.empty()) return robotlink::failure("usage", std::string(use.why) + "; omit " + given);
  }
  return arcos.check(run.scene);
}

}  // namespace app
