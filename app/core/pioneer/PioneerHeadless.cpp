// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/pioneer/PioneerHeadless.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/core/pioneer/PioneerFeed.h"
#include "app/core/pioneer/PioneerRun.h"
#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/spread/OtherProgram.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/RobotUse.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = PlatformField::Kind;

constexpr std::chrono::milliseconds kHeadlessStep{10};
constexpr char kMap[] = "map", kRobot[] = "robot", kSeconds[] = "seconds", kMotors[] = "motors",
               kTexts[] = "texts", kOwn[] = "own";

PioneerRun::Listeners robotListeners(std::ostream& errors, bool texts) {
  PioneerRun::Listeners listeners;
  listeners.trouble = [&errors](const std::string& robot, const robotlink::Process&,
                                const std::string& text) { errors << robot << ": " << text << "\n"; };
  listeners.hosting = [&errors](const std::string&, robotlink::Instant,
                                const robotcontrol::HostingStatus& status) {
    if (!status.text().empty()) errors << status.text() << "\n" << status.stack();
  };
  if (texts) {
    listeners.queue = [&errors](const std::string& robot, const auto& queue) {
      printTexts(errors, robot, *queue);
    };
    listeners.platform = [&errors](const std::string& robot, robotlink::Instant, const std::string& text) {
      errors << robot << ": " << text << "\n";
    };
  }
  return listeners;
}

/// Steps the run until its end and prints changes of the connection. Returns whether the robot was ever
/// connected.
bool drive(PioneerRun& run, double seconds, const HeadlessConsole& console) {
  const robotlink::Instant end = run.clock().now() + robotlink::fromSeconds(seconds);
  std::string reported;
  bool connected = false;
  auto due = std::chrono::steady_clock::now();
  while (!console.interrupted() && (seconds == 0 || run.clock().now() < end)) {
    run.step();
    const auto& session = run.platform().driver().session();
    connected = connected || session.isConnected();
    if (const std::string text = session.describe(); text != reported) {
      console.errors << std::fixed << std::setprecision(3) << robotlink::seconds(run.clock().now()) << "  "
                     << text << "\n";
      reported = text;
    }
    due += kHeadlessStep;
    std::this_thread::sleep_until(due);
  }
  return connected;
}

json pioneerFigures(const PioneerRun& run, bool connected) {
  const auto& statistics = run.platform().driver().session().statistics();
  return {{"address", run.options().url},
          {"layout", run.layout().string()},
          {"connected", connected},
          {"real_seconds", robotlink::seconds(run.clock().now())},
          {"packets", statistics.packets},
          {"standard_informations", statistics.information},
          {"undecodable_packets", statistics.undecodable},
          {"scans", statistics.scans},
          {"connections", statistics.connections},
          {"losses", statistics.losses},
          {"round_trip_s", robotlink::seconds(statistics.roundTrip)},
          {"longest_gap_s", robotlink::seconds(statistics.longestGap)}};
}

std::string figuresText(const json& figures) {
  std::ostringstream text;
  for (const auto& [name, value] : figures.items()) {
    text << std::left << std::setw(24) << name
         << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
  }
  return text.str();
}

tl::expected<HeadlessSummary, robotlink::Errors> runPioneer(const PioneerOptions& options,
                                                            const HeadlessChoices& choices,
                                                            const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const auto recorder = choices.record.start();
  if (!recorder) return tl::unexpected(robotlink::Errors{recorder.error()});
  auto run =
      PioneerRun::create(options, robotListeners(console.errors, flagOf(values, kTexts)), recorder->get());
  if (!run) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(choices.record.file, ignored);
    return tl::unexpected(run.error());
  }
  printMapNotes(console.errors, (*run)->map().get());
  const bool connected = drive(**run, numberOf(values, kSeconds), console);
  const json figures = pioneerFigures(**run, connected);
  run->reset();
  const ExitStatus recorded = *recorder ? finishRecording(**recorder, console.errors) : kDone;
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), connected ? recorded : kFailed};
}

/// Prints what concerns the links between programs, which users should see without asking for it.
std::function<void(const std::string& text)> spreadReport(const HeadlessConsole& console) {
  return [&console](const std::string& text) { console.errors << text + "\n" << std::flush; };
}

PioneerOptions pioneerOptionsOf(const HeadlessChoices& choices) {
  const FormValues& values = choices.options.values;
  PioneerOptions options{.url = choices.platform};
  options.robot = textOf(values, kRobot, options.robot);
  if (!choices.layout.empty()) options.layout = layoutNamed(choices.layout);
  options.map = textOf(values, kMap);
  options.solutions = choices.solutions;
  options.motorsOn = flagOf(values, kMotors);
  options.spread = choices.spread;
  options.hosting.ownProcesses = flagOf(values, kOwn);
  return options;
}

robotlink::Result<HeadlessServing> prepareServedPioneer(const HeadlessChoices& choices,
                                                        const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  PioneerOptions options = pioneerOptionsOf(choices);
  options.spreadReport = spreadReport(console);
  HeadlessServing serving{PioneerFeed::opening(std::move(options))};
  if (const double seconds = numberOf(values, kSeconds); seconds > 0) serving.seconds = seconds;
  serving.texts = flagOf(values, kTexts);
  return serving;
}

robotlink::Result<HeadlessPlatform::Run> preparePioneer(const HeadlessChoices& choices) {
  return [options = pioneerOptionsOf(choices), choices](const HeadlessConsole& console) {
    PioneerOptions reporting = options;
    reporting.spreadReport = spreadReport(console);
    return runPioneer(reporting, choices, console);
  };
}

/// What the robot of a program without the platform is.
tl::expected<HostedRobot, robotlink::Errors> hostedRobotOf(const PioneerOptions& options) {
  auto description = readRobot(options.kind);
  if (!description) return tl::unexpected(description.error());
  const auto use = readUse(options.kind);
  if (!use) return tl::unexpected(use.error());
  const std::filesystem::path fieldOfKind = fieldFile(use->field);
  auto field = readField(fieldOfKind);
  if (!field) return tl::unexpected(field.error());
  HostedRobot robot{options.robot, use->teamOf(options.robot), *description, *field, nullptr, fieldOfKind};
  if (options.map.empty()) return robot;
  auto map = robotlink::GroundMap::load(options.map);
  if (!map) return tl::unexpected(map.error());
  robot.map = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  return robot;
}

std::filesystem::path pioneerLayoutOf(const HeadlessChoices& choices) {
  const PioneerOptions options = pioneerOptionsOf(choices);
  if (!options.layout.empty()) return options.layout;
  const auto description = readRobot(options.kind);
  return description ? layoutFile(**description) : std::filesystem::path();
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherProgram(const PioneerOptions& options,
                                                                 double seconds,
                                                                 const HeadlessConsole& console) {
  auto layout = readLayoutWith(options.layout, options.solutions);
  if (!layout) return tl::unexpected(layout.error());
  auto robot = hostedRobotOf(options);
  if (!robot) return tl::unexpected(robot.error());
  const auto description = robot->description;
  OtherProgram::Parts parts{
      .robot = std::move(*robot),
      .layout = std::move(*layout),
      .options = options.spread,
      .platform = [&](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
        return std::make_unique<PioneerPlatform>(clock, options.robot, *description,
                                                 PioneerDriver::Options{.address = options.url});
      },
      .report = spreadReport(console)};
  const auto program = OtherProgram::create(std::move(parts));
  if (!program) return tl::unexpected(program.error());
  const bool heard = (*program)->run(seconds, console.interrupted);
  const json figures = {{"program", options.spread.program}, {"heard", heard}};
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), heard ? kDone : kFailed};
}

robotlink::Result<HeadlessPlatform::Run> prepareOtherProgram(const HeadlessChoices& choices) {
  PioneerOptions options = pioneerOptionsOf(choices);
  options.layout = pioneerLayoutOf(choices);
  const double seconds = numberOf(choices.options.values, kSeconds);
  return [options, seconds](const HeadlessConsole& console) {
    return runOtherProgram(options, seconds, console);
  };
}

}  // namespace

HeadlessPlatform headlessPioneer() {
  return {.help = "a Pioneer: tcp://HOST[:PORT], serial://DEVICE[?baud=RATE]",
          .usage = "a robot's address: tcp://HOST:PORT or serial://DEVICE?baud=RATE",
          .options = {{.name = kMap, .help = "Robots: a map (.map) of where it drives", .option = "--map"},
                      {.name = kRobot,
                       .help = "Robots: its name (" + PioneerOptions{}.robot + ")",
                       .option = "--robot",
                       .check = robotName},
                      {.name = kSeconds,
                       .kind = Kind::kNumber,
                       .help = "Robots: how long it runs (until Ctrl-C)",
                       .initial = 0.0,
                       .noun = "duration",
                       .max = 1e6,
                       .decimals = 3,
                       .unit = "s",
                       .option = "--seconds"},
                      {.name = kMotors,
                       .kind = Kind::kFlag,
                       .help = "Robots: switches the motors on as soon as it is connected",
                       .initial = false,
                       .option = "--motors"},
                      {.name = kTexts,
                       .kind = Kind::kFlag,
                       .help = "Robots: prints the program's text messages on stderr",
                       .initial = false,
                       .option = "--texts"},
                      ownProcessField()},
          .prepare = preparePioneer,
          .prepareServing = prepareServedPioneer,
          .layoutOf = pioneerLayoutOf,
          .prepareOther = prepareOtherProgram};
}

}  // namespace app
