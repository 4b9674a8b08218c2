// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl platform`: only the body of a robot; its program runs remotely.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/core/platform/NumberRange.h"
#include "app/core/platform/RobotName.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/body/BodyProgram.h"
#include "app/platforms/pioneer/PioneerOptions.h"
#include "app/platforms/real/RealFeed.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/run/ListenOptions.h"

namespace app {
namespace {

/// Frames of a body that is not simulated come from a thread of their own.
constexpr std::chrono::milliseconds kBodyPeriod{5};

struct PlatformArguments {
  std::string platform;
  std::string robot = pioneerOptions({}).robot;
  std::vector<std::string> models;
  std::uint64_t seed = 1;
  double seconds = 0;
  double watchdog = 0.5;
  bool noNoise = false;
  bool motors = false;
  bool isQuiet = false;
  ListenOptions listen;
};

int refusePlatform(const std::string& why) {
  std::cerr << "robotctl platform: " << why << "\n";
  return kUsage;
}

robotlink::Result<PlatformOpening> bodiesOf(const PlatformArguments& arguments,
                                            BodyProgram::Options options) {
  // The name of a shipped scene, too; addresses stay as they are.
  const std::string source = sceneNamed(arguments.platform).string();
  const PlatformAdapter* adapter = adapterFor(source);
  if (adapter != nullptr && adapter->time == TimeKind::kSimulated) {
    RunOptions run = defaultSimulation();
    run.scene = source;
    run.models.assign(arguments.models.begin(), arguments.models.end());
    run.world.seed = arguments.seed;
    run.world.noise = !arguments.noNoise;
    run.instead = BodyProgram::maker(std::move(options));
    return SimulationFeed::opening(run);
  }
  if (adapter != nullptr && adapter->name == std::string_view(kPioneerAdapter)) {
    options.period = kBodyPeriod;
    RealRobotOptions robot = pioneerOptions(arguments.platform, arguments.motors);
    robot.robot = arguments.robot;
    robot.program.instead = BodyProgram::maker(std::move(options));
    return RealFeed::opening(std::move(robot));
  }
  return robotlink::failure("usage", arguments.platform +
                                         " has no body: a platform is a scene, a map, or a robot's address "
                                         "(tcp://HOST:PORT, serial://DEVICE?baud=RATE)");
}

int offerBodies(const PlatformArguments& arguments) {
  const auto inbox = std::make_shared<BodyInbox>();
  auto opening = bodiesOf(arguments, {inbox, robotlink::fromSeconds(arguments.watchdog)});
  if (!opening) return refusePlatform(opening.error().text);
  ServeOptions options;
  if (arguments.seconds > 0) options.seconds = arguments.seconds;
  options.texts = !arguments.isQuiet;
  options.bodies = inbox;
  return arguments.listen.serve(std::move(*opening), options, {});
}

}  // namespace

void addPlatformCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<PlatformArguments>();
  CLI::App* command = app.add_subcommand(
      "platform",
      "Offers only the body of a robot, simulated or real: sensor readings out, commands in. Its program "
      "runs "
      "elsewhere: robotctl run --platform ws://HOST:PORT, or robotcontrol ws://HOST:PORT --program here");
  command
      ->add_option("platform", arguments->platform,
                   "A scene (.sdf, .world), a map (.map), or a Pioneer: tcp://HOST[:PORT], "
                   "serial://DEVICE[?baud=RATE]")
      ->required();
  arguments->listen.addTo(*command);
  command
      ->add_option(
          "--watchdog", arguments->watchdog,
          "The robot stops if no commands arrive, or if they are based on readings older than this, s")
      ->check(numberFrom(0.05, 60))
      ->capture_default_str();
  command->add_option("--robot", arguments->robot, "The name of a real robot")
      ->check([](const std::string& text) { return robotName(text); })
      ->capture_default_str();
  command->add_flag("--motors", arguments->motors,
                    "Switches the motors of a real robot on as soon as it is connected");
  command
      ->add_option("--models", arguments->models,
                   "Folders in which model://NAME is searched first, separated by colons")
      ->expected(1)
      ->take_all()
      ->delimiter(':')
      ->type_name("FOLDER");
  command->add_option("--seed", arguments->seed, "Seed of a simulation's noise")->capture_default_str();
  command->add_flag("--no-noise", arguments->noNoise, "Simulated sensors without noise");
  command->add_option("--seconds", arguments->seconds, "How long it runs (until Ctrl-C)")
      ->check(numberFrom(0, 1e6));
  command->add_flag("--quiet", arguments->isQuiet, "Does not print the events of the bodies");
  command->callback(
      [arguments, &status] { status = withResources([&] { return offerBodies(*arguments); }); });
}

}  // namespace app
