// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl sim`: simulation of a scene with the programs of its robots.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/Pace.h"
#include "app/core/platform/ProgramTroubles.h"
#include "app/core/platform/RecordOptions.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/truth/ErrorFigures.h"
#include "app/core/truth/ErrorKeys.h"
#include "app/platforms/simulated/BallTrials.h"
#include "app/platforms/simulated/RunEnd.h"
#include "app/platforms/simulated/SceneResources.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "app/robotctl/run/SimArguments.h"
#include "app/robotctl/run/SimFigures.h"
#include "app/robotctl/run/SimScript.h"
#include "app/robotctl/run/SimTrials.h"
#include "app/robotctl/run/SnapshotOptions.h"
#include "app/robotctl/run/TeamOptions.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Printable.h"
#include "robotlink/base/UnfinishedFile.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {
namespace {

constexpr robotlink::Duration kProgressEvery = std::chrono::milliseconds(100);
/// A slow simulation looks for signals this often while it waits.
constexpr std::chrono::milliseconds kLookEvery{100};
constexpr std::chrono::hours kNoEnd{24 * 365};
/// Stands for the names of all robots.
constexpr char kAllRobots[] = "all";

using nlohmann::json;

/// The outputs of a run.
struct SimOutputs {
  /// Null: not requested.
  std::unique_ptr<robotlink::TruthErrors> errors = nullptr;
  /// Null: none.
  std::unique_ptr<LabeledImages> images = nullptr;
  std::unique_ptr<logplayer::Recorder> recorder = nullptr;
};

using SharedTroubles = std::shared_ptr<ProgramTroubles>;

/// Listeners that hear only of what goes wrong with programs.
SimulatedRun::Listeners listenersTo(const SharedTroubles& troubles) {
  SimulatedRun::Listeners listeners;
  listeners.trouble = [troubles](const std::string& robot, const robotlink::Process&,
                                 const std::string& text) { troubles->note(robot, text); };
  listeners.hosting = [troubles](const std::string& robot, robotlink::Instant,
                                 const robotcontrol::HostingStatus& status) {
    troubles->note(robot, status);
  };
  listeners.control = [troubles](const std::string& controller, robotlink::Instant, const std::string& text) {
    troubles->note(controller, text);
  };
  return listeners;
}

SimulatedRun::Listeners listenersFor(const SimArguments& arguments, const SharedTroubles& troubles,
                                     const SimOutputs& outputs) {
  SimulatedRun::Listeners listeners = listenersTo(troubles);
  if (arguments.texts || outputs.errors) {
    listeners.queue = [texts = arguments.texts, errors = outputs.errors.get()](const std::string& robot,
                                                                               const auto& queue) {
      if (texts) printTexts(std::cerr, robot, *queue);
      if (errors != nullptr) errors->add(robot, *queue);
    };
  }
  if (arguments.texts) {
    listeners.game = [](robotlink::Instant time, const std::string& text) {
      printText(std::cerr, time, "game", text);
    };
  }
  if (LabeledImages* images = outputs.images.get()) {
    listeners.labeled = [images](const std::string& robot, const auto& image, const auto& classes) {
      images->add(robot, image, classes);
    };
  }
  return listeners;
}

/// Waits until a step is due; false if a signal arrived first.
bool waitUntilDue(Pace::RealTime due) {
  for (auto now = std::chrono::steady_clock::now(); now < due; now = std::chrono::steady_clock::now()) {
    std::this_thread::sleep_until(std::min(due, now + kLookEvery));
    if (Interrupt::noted()) return false;
  }
  return true;
}

/// Steps to the end; false if a signal arrived first. A recording waits for the disk, and the run for the
/// recording: nothing is urgent here.
robotlink::Result<bool> simulate(SimulatedRun& run, const SimArguments& arguments,
                                 logplayer::Recorder* recorder) {
  auto snapshots = arguments.snapshots.wanted();
  if (!snapshots) return tl::unexpected(snapshots.error());
  Pace pace;
  pace.setSpeed(arguments.speed);
  const auto& clock = run.world().clock();
  pace.restart(std::chrono::steady_clock::now(), clock.now());
  const robotlink::Instant end = clock.now() + robotlink::fromSeconds(arguments.seconds);
  robotlink::Instant reported = clock.now();
  if (auto written = writeDueSnapshots(run, *snapshots); !written) return tl::unexpected(written.error());
  while (clock.now() < end) {
    if (Interrupt::noted()) return false;
    if (arguments.speed > 0 && !waitUntilDue(pace.due(clock.now()))) return false;
    run.step();
    if (auto written = writeDueSnapshots(run, *snapshots); !written) return tl::unexpected(written.error());
    if (recorder != nullptr) recorder->waitForRoom();
    if (!arguments.progress || clock.now() - reported < kProgressEvery) continue;
    reported += kProgressEvery;
    std::cerr << std::fixed << std::setprecision(3) << robotlink::seconds(clock.now()) << " s" << std::endl;
  }
  return true;
}

/// Reports the result of writing labeled images, if there are any.
int finishImages(const LabeledImages* images, const std::string& folder) {
  if (images == nullptr) return kDone;
  if (!images->outcome()) return printErrors({images->outcome().error()});
  std::cerr << folder << ": " << images->written() << " images with their true classes\n";
  return kDone;
}

/// Opens what is written. Returns what cannot be.
robotlink::Result<std::shared_ptr<SimOutputs>> openOutputs(const SimArguments& arguments) {
  auto images = arguments.camera.labeledImages();
  if (!images) return tl::unexpected(images.error());
  auto recorder = arguments.record.start();
  if (!recorder) return tl::unexpected(recorder.error());
  return std::make_shared<SimOutputs>(
      SimOutputs{arguments.errors ? std::make_unique<robotlink::TruthErrors>() : nullptr, std::move(*images),
                 std::move(*recorder)});
}

void printFigures(const SimArguments& arguments, json figures, const ProgramTroubles& troubles) {
  figures["troubles"] = troublesJson(troubles);
  if (arguments.digest && !arguments.asJson) {
    std::cout << figures["digest"].get<std::string>() << "\n";
  } else {
    std::cout << (arguments.asJson ? jsonOutput(figures) : figuresText(figures));
  }
}

/// Plays a game whose programs are made, and prints the result.
int playGame(SimulatedRun& run, const SimArguments& arguments, const SimOutputs& outputs,
             const ProgramTroubles& troubles) {
  if (const auto restored = arguments.snapshots.restore(run); !restored)
    return printErrors({restored.error()});
  const auto start = std::chrono::steady_clock::now();
  const auto played = simulate(run, arguments, outputs.recorder.get());
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  int status = outputs.recorder ? finishRecording(*outputs.recorder, std::cerr) : kDone;
  if (const int written = finishImages(outputs.images.get(), arguments.camera.labeledFolder);
      written != kDone)
    status = written;
  if (!played) return printErrors({played.error()});
  if (!*played) status = kFailed;
  json figures = figuresOf(run, real);
  if (outputs.errors) figures["errors"] = errorFigures(*outputs.errors);
  printFigures(arguments, std::move(figures), troubles);
  return withTroubles(status, troubles);
}

int runOnce(const SimArguments& arguments) {
  const Interrupt interrupt;
  const auto opened = openOutputs(arguments);
  if (!opened) return printErrors({opened.error()});
  const SimOutputs& outputs = **opened;
  // Removes the file of the recording if the program ends before anything is recorded.
  std::optional<robotlink::UnfinishedFile> unfinished;
  if (outputs.recorder) unfinished.emplace(arguments.record.file);
  const auto troubles = std::make_shared<ProgramTroubles>(std::cerr);
  TerminalProgress progress;
  RunOptions options = arguments.run;
  if (arguments.errors) {
    options.preset = presetForErrors(options.preset);
    for (auto& [name, preset] : options.robotPresets) preset = presetForErrors(preset);
  }
  options.progress = progress.function();
  auto made = SimulatedRun::create(std::move(options), listenersFor(arguments, troubles, outputs),
                                   outputs.recorder.get());
  progress.erase();
  if (!made) {
    std::error_code ignored;
    if (outputs.recorder) std::filesystem::remove(arguments.record.file, ignored);
    return printErrors(made.error());
  }
  const RunEnd end(std::move(*made), *opened);
  SimulatedRun& run = end.run();
  if (outputs.errors) outputs.errors->setField(run.field());
  for (const std::string& robot : arguments.ownProcesses) {
    if (robot == kAllRobots || run.description(robot)) continue;
    return printErrors({{"sim.no-robot", "there is no robot " + robot + " in this scene", {robot}, {}}});
  }
  if (const auto known = TeamOptions::check(run); !known) return printErrors({known.error()});
  printMapNotes(std::cerr, run.map().get());
  if (const std::string text = leftOutText(run.world().simulation().scene()); !text.empty())
    std::cerr << robotlink::printable(text) << "\n";
  unfinished.reset();
  return playGame(run, arguments, outputs, *troubles);
}

int runTrials(const SimArguments& arguments) {
  BallTrials trials;
  trials.run = arguments.run;
  const auto troubles = std::make_shared<ProgramTroubles>(std::cerr);
  trials.listeners = listenersTo(troubles);
  trials.firstSeed = arguments.run.world.seed;
  trials.count = arguments.trials;
  trials.radius = arguments.radius;
  trials.goals = arguments.goals;
  trials.seconds = arguments.seconds;
  return playTrials(std::move(trials), *troubles, arguments.asJson);
}

/// Measures how the first robot walks; its behavior obeys unless another one was chosen.
int runWalk(const SimArguments& arguments) {
  WalkTrial trial{.run = arguments.run, .asked = {}, .seconds = arguments.seconds};
  const auto troubles = std::make_shared<ProgramTroubles>(std::cerr);
  trial.listeners = listenersTo(troubles);
  trial.run.solutions.try_emplace("behavior", "obey");
  std::vector<double> asked = arguments.walk;
  asked.resize(3);
  trial.asked = {asked[0], asked[1], robotlink::radians(asked[2])};
  return playWalk(trial, *troubles, arguments.asJson);
}

/// Runs a simulation whose robots are driven by other programs.
int runForClients(const SimArguments& arguments, bool secondsGiven, bool speedGiven) {
  ArcosRun run{.scene = arguments.run.scene,
               .world = arguments.run.world,
               .seconds = {},
               .speed = speedGiven ? arguments.speed : 1,
               .asJson = arguments.asJson,
               .models = arguments.run.models};
  run.world.noise = !arguments.noNoise;
  if (secondsGiven) run.seconds = arguments.seconds;
  return runArcos(arguments.arcos, run);
}

/// Runs a simulation that people at other programs watch and steer.
int runListening(const SimArguments& arguments, bool secondsGiven, bool speedGiven) {
  ServeOptions options{.speed = speedGiven ? arguments.speed : 1, .texts = arguments.texts};
  options.isPaused = arguments.isPaused;
  if (secondsGiven) options.seconds = arguments.seconds;
  options.troubles = std::make_shared<ProgramTroubles>(std::cerr);
  return arguments.listen.serve(SimulationFeed::opening(arguments.run), options, arguments.record);
}

/// Sets where programs run, and how long their modules may take.
void applyHosting(SimArguments& arguments, bool threads) {
  RunOptions& run = arguments.run;
  for (const std::string& robot : arguments.ownProcesses) {
    if (robot != kAllRobots) run.hosting.choose(robot, true);
  }
  if (std::ranges::find(arguments.ownProcesses, kAllRobots) != arguments.ownProcesses.end())
    run.hosting.choose({}, true);
  run.hosting.threads = threads;
  run.own.memoryLimit = arguments.programMemory << 20U;
  run.patience = std::chrono::milliseconds(std::llround(1000 * arguments.patience));
  // A program in its own process may be halted in a debugger for any time.
  run.own.patience = run.patience.count() > 0 ? run.patience : kNoEnd;
}

int simUsage(const robotlink::Error& error) {
  std::cerr << "robotctl sim: " << error.text << "\n";
  return kUsage;
}

int runSim(const CLI::App& sim, SimArguments& arguments) {
  if (const auto found = findScene(arguments.run.scene); !found) return simUsage(found.error());
  if (const auto fits = arguments.check(sim); !fits) return simUsage(fits.error());
  const bool secondsGiven = sim.get_option("--seconds")->count() > 0;
  const bool speedGiven = sim.get_option("--speed")->count() > 0;
  arguments.run.models.assign(arguments.models.begin(), arguments.models.end());
  if (arguments.arcos.given()) return runForClients(arguments, secondsGiven, speedGiven);
  if (const auto wanted = arguments.snapshots.wanted(); !wanted) return simUsage(wanted.error());
  if (const auto chosen = arguments.teams.applyTo(arguments.run); !chosen) {
    const bool isUsage = chosen.error().front().id == "usage";
    return isUsage ? simUsage(chosen.error().front()) : printErrors(chosen.error());
  }
  const bool threads = arguments.executor == "threads";
  arguments.camera.applyTo(arguments.run);
  arguments.arcos.applyTo(arguments.run);
  arguments.run.world.noise = !arguments.noNoise;
  applyHosting(arguments, threads);
  // Threads run in real time: nothing waits for them.
  if (threads && !speedGiven) arguments.speed = 1;
  if (!arguments.script.empty()) return runSimScript(arguments.run, arguments.script);
  if (arguments.listen.given()) return runListening(arguments, secondsGiven, speedGiven);
  if (!arguments.walk.empty() && !secondsGiven) arguments.seconds = 5;
  if (!arguments.walk.empty()) return runWalk(arguments);
  if (arguments.trials > 0 && !secondsGiven) arguments.seconds = 60;
  return arguments.trials > 0 ? runTrials(arguments) : runOnce(arguments);
}

}  // namespace

void addSimCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<SimArguments>();
  CLI::App* sim = app.add_subcommand("sim", "Simulates a scene with the programs of its robots");
  arguments->addTo(*sim);
  sim->callback(
      [arguments, sim, &status] { status = withResources([&] { return runSim(*sim, *arguments); }); });
}

}  // namespace app
