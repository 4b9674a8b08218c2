// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/real/RealHeadless.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/real/RealFeed.h"
#include "app/core/spread/OtherProgram.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/GroundMap.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = PlatformField::Kind;

constexpr std::chrono::milliseconds kHeadlessStep{10};
constexpr char kMap[] = "map", kRobot[] = "robot", kSeconds[] = "seconds", kTexts[] = "texts", kOwn[] = "own";

RealRun::Listeners robotListeners(std::ostream& errors, bool texts) {
  RealRun::Listeners listeners;
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
bool drive(RealRun& run, double seconds, const HeadlessConsole& console) {
  const robotlink::Instant end = run.clock().now() + robotlink::fromSeconds(seconds);
  std::string reported;
  bool connected = false;
  auto due = std::chrono::steady_clock::now();
  while (!console.interrupted() && (seconds == 0 || run.clock().now() < end)) {
    run.step();
    connected = connected || run.platform().isConnected();
    if (const std::string text = run.platform().connectionText(); text != reported) {
      console.errors << std::fixed << std::setprecision(3) << robotlink::seconds(run.clock().now()) << "  "
                     << text << "\n";
      reported = text;
    }
    due += kHeadlessStep;
    std::this_thread::sleep_until(due);
  }
  return connected;
}

json realFigures(const RealRun& run, bool connected) {
  json figures = {{"address", run.options().url},
                  {"layout", run.layout().string()},
                  {"connected", connected},
                  {"real_seconds", robotlink::seconds(run.clock().now())}};
  for (const auto& [name, value] : run.platform().connectionFigures())
    std::visit([&, key = name](auto number) { figures[key] = number; }, value);
  return figures;
}

std::string figuresText(const json& figures) {
  std::ostringstream text;
  for (const auto& [name, value] : figures.items()) {
    text << std::left << std::setw(24) << name
         << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
  }
  return text.str();
}

tl::expected<HeadlessSummary, robotlink::Errors> runReal(const RealRobotOptions& options,
                                                         const HeadlessChoices& choices,
                                                         const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const auto recorder = choices.record.start();
  if (!recorder) return tl::unexpected(robotlink::Errors{recorder.error()});
  auto run =
      RealRun::create(options, robotListeners(console.errors, flagOf(values, kTexts)), recorder->get());
  if (!run) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(choices.record.file, ignored);
    return tl::unexpected(run.error());
  }
  printMapNotes(console.errors, (*run)->map().get());
  const bool connected = drive(**run, numberOf(values, kSeconds), console);
  const json figures = realFigures(**run, connected);
  run->reset();
  const ExitStatus recorded = *recorder ? finishRecording(**recorder, console.errors) : kDone;
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), connected ? recorded : kFailed};
}

/// Prints what concerns the links between programs, which users should see without asking for it.
std::function<void(const std::string& text)> spreadReport(const HeadlessConsole& console) {
  return [&console](const std::string& text) { console.errors << text + "\n" << std::flush; };
}

RealRobotOptions robotOf(const RealHeadless& declared, const HeadlessChoices& choices) {
  const FormValues& values = choices.options.values;
  RealRobotOptions options = declared.robotOf(choices.platform, values);
  options.robot = textOf(values, kRobot, options.robot);
  if (!choices.layout.empty()) options.layout = layoutNamed(choices.layout);
  options.map = textOf(values, kMap);
  for (const auto& [task, solution] : choices.solutions) options.solutions[task] = solution;
  options.spread = choices.spread;
  options.hosting.ownProcesses = flagOf(values, kOwn);
  return options;
}

robotlink::Result<HeadlessServing> prepareServedReal(const RealHeadless& declared,
                                                     const HeadlessChoices& choices,
                                                     const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  RealRobotOptions options = robotOf(declared, choices);
  options.spreadReport = spreadReport(console);
  HeadlessServing serving{RealFeed::opening(std::move(options))};
  if (const double seconds = numberOf(values, kSeconds); seconds > 0) serving.seconds = seconds;
  serving.texts = flagOf(values, kTexts);
  return serving;
}

robotlink::Result<HeadlessPlatform::Run> prepareReal(const RealHeadless& declared,
                                                     const HeadlessChoices& choices) {
  return [options = robotOf(declared, choices), choices](const HeadlessConsole& console) {
    RealRobotOptions reporting = options;
    reporting.spreadReport = spreadReport(console);
    return runReal(reporting, choices, console);
  };
}

std::filesystem::path layoutOf(const RealHeadless& declared, const HeadlessChoices& choices) {
  const RealRobotOptions options = robotOf(declared, choices);
  if (!options.layout.empty()) return options.layout;
  const auto description = readRobot(options.kind);
  return description ? layoutFile(**description) : std::filesystem::path();
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherProgram(const RealRobotOptions& options,
                                                                 double seconds,
                                                                 const HeadlessConsole& console) {
  auto layout = readLayoutWith(options.layout, options.solutions);
  if (!layout) return tl::unexpected(layout.error());
  auto robot = hostedRobot(options);
  if (!robot) return tl::unexpected(robot.error());
  // Whose address is no address says so here, before anything is opened.
  const robotlink::SteadyClock probe;
  if (const auto platform = options.platform(probe, options.robot, *robot->description); !platform)
    return tl::unexpected(robotlink::Errors{platform.error()});
  const auto description = robot->description;
  OtherProgram::Parts parts{
      .robot = std::move(*robot),
      .layout = std::move(*layout),
      .options = options.spread,
      .platform = [&](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
        return std::move(options.platform(clock, options.robot, *description)).value();
      },
      .report = spreadReport(console)};
  const auto program = OtherProgram::create(std::move(parts));
  if (!program) return tl::unexpected(program.error());
  const bool heard = (*program)->run(seconds, console.interrupted);
  const json figures = {{"program", options.spread.program}, {"heard", heard}};
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), heard ? kDone : kFailed};
}

robotlink::Result<HeadlessPlatform::Run> prepareOtherProgram(const RealHeadless& declared,
                                                             const HeadlessChoices& choices) {
  RealRobotOptions options = robotOf(declared, choices);
  options.layout = layoutOf(declared, choices);
  const double seconds = numberOf(choices.options.values, kSeconds);
  return [options, seconds](const HeadlessConsole& console) {
    return runOtherProgram(options, seconds, console);
  };
}

}  // namespace

HeadlessPlatform headlessReal(RealHeadless declared) {
  std::vector<PlatformField> options{
      {.name = kMap, .help = "Robots: a map (.map) of where it drives", .option = "--map"},
      {.name = kRobot,
       .help = "Robots: its name (" + declared.robot + ")",
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
      {.name = kTexts,
       .kind = Kind::kFlag,
       .help = "Robots: prints the program's text messages on stderr",
       .initial = false,
       .option = "--texts"},
      ownProcessField()};
  options.insert(options.end(), declared.options.begin(), declared.options.end());
  const auto shared = std::make_shared<const RealHeadless>(std::move(declared));
  return {.help = shared->help,
          .usage = shared->usage,
          .options = std::move(options),
          .prepare = [shared](const HeadlessChoices& choices) { return prepareReal(*shared, choices); },
          .prepareServing =
              [shared](const HeadlessChoices& choices, const HeadlessConsole& console) {
                return prepareServedReal(*shared, choices, console);
              },
          .layoutOf = [shared](const HeadlessChoices& choices) { return layoutOf(*shared, choices); },
          .prepareOther =
              [shared](const HeadlessChoices& choices) { return prepareOtherProgram(*shared, choices); }};
}

}  // namespace app
