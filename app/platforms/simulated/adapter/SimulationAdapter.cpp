// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of simulations: the files that it opens, and the form for users.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "app/core/Workbench.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/platforms/simulated/adapter/SceneCommands.h"
#include "app/platforms/simulated/adapter/SimulationCommands.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/SceneFileKind.h"

namespace app {
namespace {

using Kind = PlatformField::Kind;
using robotlink::Result;

constexpr int kMaxRobots = 100, kLastPort = 65535;
constexpr char kBothTeams[] = "both";

bool isMap(const std::string& scene) {
  return simcore::isMapFile(sceneNamed(scene));
}

/// Whether a source is a file that can be simulated, by its name.
bool isScene(const std::string& source) {
  return simcore::isSceneFile(source);
}

// ---- Opening

/// The robots to add. Unset: as the scene's kind of file decides.
std::optional<simcore::RobotsToAdd> robotsToAdd(const FormValues& values, std::uint64_t seed) {
  if (!values.contains("robots") && !values.contains("kind")) return std::nullopt;
  // A user who names a model wants a robot of it.
  return simcore::RobotsToAdd{.model = textOf(values, "kind"),
                              .count = static_cast<int>(numberOf(values, "robots", 1)),
                              .seed = seed,
                              .teams = teamsNamed(textOf(values, "teams", kBothTeams))};
}

/// Folders with colons between them, as in PATH.
std::vector<std::filesystem::path> foldersIn(const std::string& text) {
  std::vector<std::filesystem::path> folders;
  std::istringstream stream(text);
  for (std::string folder; std::getline(stream, folder, ':');) {
    if (!folder.empty()) folders.push_back(std::filesystem::absolute(folder));
  }
  return folders;
}

std::optional<ArcosPorts::Options> portsToOpen(const FormValues& values) {
  const double port = numberOf(values, "port");
  if (port <= 0) return std::nullopt;
  ArcosPorts::Options ports;
  ports.firstPort = static_cast<std::uint16_t>(port);
  if (flagOf(values, "network")) ports.address = "0.0.0.0";
  return ports;
}

/// Changes the options of the last simulation to those that were chosen.
void applySimulationChoices(const FormValues& values, RunOptions& options) {
  if (values.contains("seed")) options.world.seed = static_cast<std::uint64_t>(numberOf(values, "seed"));
  options.robots = robotsToAdd(values, options.world.seed);
  options.ports = portsToOpen(values);
  options.world.kinematic = flagOf(values, "kinematic", options.world.kinematic);
  options.world.noise = flagOf(values, "noise", options.world.noise);
  if (values.contains("threads")) {
    const int threads = static_cast<int>(numberOf(values, "threads"));
    options.world.threads = threads > 0 ? threads : robotlink::ThreadPool::cores();
  }
  if (values.contains("own")) options.hosting.choose({}, flagOf(values, "own"));
  const std::string executor = textOf(values, "executor");
  if (!executor.empty()) options.hosting.threads = executor == nameOf(ExecutorKind::kThreads);
  // Current choices take precedence over earlier ones, if they do not fit together.
  const bool isOwnChosen = flagOf(values, "own");
  if (isOwnChosen && executor.empty()) options.hosting.threads = false;
  if (!isOwnChosen && !executor.empty() && options.hosting.threads) options.hosting.choose({}, false);
  if (values.contains("models")) options.models = foldersIn(textOf(values, "models"));
}

std::vector<std::string> linesIn(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Result<PlatformOpening> openSimulation(const PlatformChoices& choices) {
  const FormValues& values = choices.values;
  if (numberOf(values, "port") + numberOf(values, "robots") > kLastPort + 1) {
    return robotlink::failure("simulation.setup",
                              "there are not enough ports above the first one; choose a lower first port");
  }
  if (values.contains("teams") && !values.contains("robots") && !values.contains("kind"))
    return robotlink::failure("simulation.setup",
                              "teams are for added robots; say how many to add (--robots)");
  RunOptions chosen;
  if (const auto done = chooseLayouts(linesIn(textOf(values, "layout")), chosen); !done)
    return tl::unexpected(done.error());
  if (const auto done = chooseSolutions(linesIn(textOf(values, "solution")), chosen); !done)
    return tl::unexpected(done.error());
  return SimulationFeed::opening(sceneNamed(choices.sources.front()), [values, chosen](RunOptions& options) {
    applySimulationChoices(values, options);
    // A choice for all robots replaces the earlier ones for robots and teams.
    if (!chosen.layout.empty()) {
      options.layout = chosen.layout;
      options.robotLayouts.clear();
    }
    for (const auto& [task, solution] : chosen.solutions) {
      for (TeamSolutions* before : {&options.robotSolutions, &options.keptSolutions})
        for (auto& [robot, solutions] : *before) solutions.erase(task);
    }
    for (const auto& [kind, layout] : chosen.layouts) options.layouts[kind] = layout;
    for (const auto& [robot, layout] : chosen.robotLayouts) options.robotLayouts[robot] = layout;
    for (const auto& [task, solution] : chosen.solutions) options.solutions[task] = solution;
    for (const auto& [robot, solutions] : chosen.robotSolutions) {
      for (const auto& [task, solution] : solutions) options.robotSolutions[robot][task] = solution;
    }
  });
}

// ---- The form

PlatformField::Items sceneItems() {
  PlatformField::Items items;
  for (const auto& file : shippedScenes()) items.push_back({file.stem().string(), file.stem().string()});
  return items;
}

PlatformField::Items kindItems() {
  PlatformField::Items items;
  for (const RobotKind& kind : simulatedRobots()) items.push_back({kind.title, kind.name});
  return items;
}

PlatformField::Items teamItems() {
  PlatformField::Items items{{.title = "All, as many in each", .value = kBothTeams}};
  for (const std::string& team : simulatedTeams()) {
    std::string title = team;
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    items.push_back({std::move(title), team});
  }
  return items;
}

/// The model of the robots in a scene, found in its text; empty: none.
std::string kindIn(const std::string& scene) {
  std::error_code ignored;
  const std::filesystem::path file = sceneNamed(scene);
  if (!std::filesystem::is_regular_file(file, ignored)) return {};
  constexpr std::size_t kEnough = 1U << 20U;
  std::string text(kEnough, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount())));
  for (const RobotKind& kind : simulatedRobots()) {
    if (text.find("model://" + kind.name + "<") != std::string::npos) return kind.name;
  }
  return {};
}

bool playsInTeams(const std::string& kind) {
  const auto kinds = simulatedRobots();
  return std::ranges::any_of(kinds,
                             [&](const RobotKind& each) { return each.name == kind && !each.teams.empty(); });
}

/// The default is to add robots of the kind that the scene contains, and one to a map.
void followScene(FormState& state, const std::string& scene) {
  const bool map = isMap(scene);
  const std::string kind = map ? simcore::RobotsToAdd{}.model : kindIn(scene);
  if (!kind.empty()) state.values["kind"] = kind;
  if (map && numberOf(state.values, "robots") == 0) state.values["robots"] = 1.0;
}

void followSimulation(FormState& state, const std::string& changed) {
  const std::string scene = textOf(state.values, "scene");
  if (changed == "scene") followScene(state, scene);
  const bool adds = numberOf(state.values, "robots") > 0;
  if (!adds) state.disabled.insert("kind");
  if (!adds || !playsInTeams(textOf(state.values, "kind"))) state.disabled.insert("teams");
  const bool ports = numberOf(state.values, "port") > 0;
  if (!ports) state.disabled.insert("network");
  if (isMap(scene) && !adds) state.hint = "A map contains no robots: set how many to add.";
  if (ports && flagOf(state.values, "network"))
    state.hint = "Anyone who can reach this computer over the network will be able to drive these robots.";
  state.complete = !scene.empty();
}

std::vector<PlatformField> robotFields() {
  return {{.name = "kind",
           .kind = Kind::kChoice,
           .label = "Kind:",
           .help = "Kind of the robots to add to the world; by default the kind of the robots in it",
           .initial = simcore::RobotsToAdd{}.model,
           .noun = "kind of robots",
           .items = kindItems,
           .group = "Robots",
           .option = "--robot",
           .remembered = "simulation_setup/1"},
          {.name = "robots",
           .kind = Kind::kNumber,
           .label = "Add:",
           .help = "How many robots are added: at the map's home or the kick-off positions first, then where "
                   "there is room",
           .initial = 0.0,
           .noun = "number of robots",
           .max = kMaxRobots,
           .emptyText = "none",
           .group = "Robots",
           .option = "--robots",
           .remembered = "simulation_setup/2"},
          {.name = "kinematic",
           .kind = Kind::kFlag,
           .label = "Moved by their odometry, without forces",
           .help = "Robots on wheels are moved by their odometry, without forces; faster with many robots: "
                   "nothing slips, and obstacles stop them",
           .initial = false,
           .group = "Robots",
           .option = "--kinematic",
           .remembered = "simulation_setup/3"}};
}

std::vector<PlatformField> portFields() {
  return {{.name = "port",
           .kind = Kind::kNumber,
           .label = "First port:",
           .help = "TCP port at which external programs reach the first ARCOS robot; each further robot has "
                   "the next port",
           .initial = 8101.0,
           .noun = "first port",
           .min = 1,
           .max = kLastPort - kMaxRobots,
           .group = "External programs",
           .toggle = "Can drive the robots over ARCOS",
           .option = "--arcos",
           .remembered = "simulation_setup/4"},
          {.name = "network",
           .kind = Kind::kFlag,
           .label = "From other computers, too",
           .help = "Anyone who can reach this computer can then drive the robots: ARCOS has no password",
           .initial = false,
           .group = "External programs",
           .remembered = "simulation_setup/5"}};
}

/// The fields that only commands and programs without a window have.
std::vector<PlatformField> hiddenFields() {
  return {{.name = "seed",
           .kind = Kind::kNumber,
           .help = "Seed of the simulation's noise",
           .initial = 1.0,
           .noun = "seed",
           .max = 9e15,  // above this, not every whole number is a double
           .isArgument = false,
           .isShown = false,
           .option = "--seed"},
          ownProcessField(),
          {.name = "executor",
           .kind = Kind::kChoice,
           .help = "How the processes of the programs are executed: lockstep, one after "
                   "another and reproducible; or threads, one each, with the layout's priorities",
           .noun = "executor",
           .items =
               [] {
                 return PlatformField::Items{{"lockstep", "lockstep"}, {"threads", "threads"}};
               },
           .isArgument = false,
           .isShown = false,
           .option = "--executor"}};
}

PlatformField sceneField() {
  return {.name = "scene",
          .kind = Kind::kChoice,
          .label = "Scene:",
          .help =
              "A shipped scene by its name, or a file: an SDFormat world, or the map of a building "
              "(.map)",
          .initial = std::string("field2002"),
          .noun = "scene",
          .items = sceneItems,
          .editable = true,
          .files = "Worlds and maps (*.sdf *.world *.map)",
          .group = "World",
          .isSource = true,
          .remembered = "simulation_setup/0"};
}

/// The fields about teams and sensors, and about the world's models and threads.
std::vector<PlatformField> playFields() {
  return {{.name = "teams",
           .kind = Kind::kChoice,
           .label = "Teams:",
           .help = "Team of the added robots, if they play; red plays toward the sky-blue goal",
           .initial = std::string(kBothTeams),
           .noun = "teams",
           .items = teamItems,
           .group = "Robots",
           .option = "--teams",
           .remembered = "simulation_setup/6"},
          {.name = "noise",
           .kind = Kind::kFlag,
           .label = "Sensors with noise",
           .help = "Sensors, cameras and odometry have the errors set in the scene; otherwise they "
                   "measure the true values",
           .initial = true,
           .group = "Robots",
           .remembered = "simulation_setup/7"},
          {.name = "models",
           .label = "Models in:",
           .help = "Folders in which model://NAME is searched first, with colons between them; the "
                   "scene editor finds models there, too",
           .noun = "folders of models",
           .emptyText = "the scene's folder and the usual ones",
           .group = "World",
           .option = "--models",
           .remembered = "simulation_setup/8"},
          {.name = "threads",
           .kind = Kind::kNumber,
           .label = "Threads:",
           .help = "How many threads share physics, sensors, images and the robots' programs; the "
                   "results are the same for any number",
           .initial = 0.0,
           .noun = "number of threads",
           .max = robotlink::ThreadPool::kMaxThreads,
           .emptyText = "one per core",
           .group = "World",
           .option = "--threads",
           .remembered = "simulation_setup/9"}};
}

PlatformForm simulationForm() {
  PlatformForm form{.name = "setup",
                    .command = "simulation.setup",
                    .commandHelp = "Opens a scene or a map and adds robots to it",
                    .menu = "file",
                    .entry = "S&imulate robots…",
                    .action = "file.simulate",
                    .icon = "simulation",
                    .keys = "Ctrl+Shift+O",
                    .entryHelp = "Opens a scene or a map and adds robots to it",
                    .title = "Simulate",
                    .accept = "&Open"};
  form.fields = {sceneField()};
  for (auto& field : robotFields()) form.fields.push_back(std::move(field));
  for (auto& field : portFields()) form.fields.push_back(std::move(field));
  for (auto& field : playFields()) form.fields.push_back(std::move(field));
  for (auto& field : hiddenFields()) form.fields.push_back(std::move(field));
  form.follow = followSimulation;
  return form;
}

const PlatformRegistration kSimulationRegistration{
    {.name = SimulationFeed::kAdapter,
     .sources = "a world (.sdf, .world) or the map of a building (.map) to simulate",
     .time = TimeKind::kSimulated,
     .opens = isScene,
     .order = 1,
     .open = openSimulation,
     .command = "simulation.open",
     .commandHelp = "Opens a scene, by its path or the name of a shipped one",
     .fileEntry = "&Open scene…",
     .fileFilter = "Worlds and maps (*.sdf *.world *.map)",
     .perspective = [](const std::string& source) { return isMap(source) ? "Drive" : ""; },
     .form = simulationForm,
     .insteadOfHeadless = "'robotctl sim' runs simulated robots",
     .commands =
         [](Workbench& workbench) {
           addSimulationCommands(workbench.commands(), workbench);
           addSceneCommands(workbench.commands(), workbench);
         }}};

}  // namespace
}  // namespace app
