// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealHeadless.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "app/platforms/real/HeadlessRobot.h"
#include "app/platforms/real/RealFeed.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/GroundMap.h"

namespace app {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds kHeadlessStep{10};

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
  json figures = {{"address", run.url()},
                  {"layout", run.layout().string()},
                  {"connected", connected},
                  {"real_seconds", robotlink::seconds(run.clock().now())}};
  for (const auto& [name, value] : run.platform().connectionFigures())
    std::visit([&, key = name](auto number) { figures[key] = number; }, value);
  return figures;
}

tl::expected<HeadlessSummary, robotlink::Errors> runReal(const RealRobotOptions& options,
                                                         const HeadlessChoices& choices,
                                                         const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const auto recorder = choices.record.start();
  if (!recorder) return tl::unexpected(robotlink::Errors{recorder.error()});
  auto run =
      RealRun::create(options, robotListeners(console.errors, flagOf(values, kTextsField)), recorder->get());
  if (!run) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(choices.record.file, ignored);
    return tl::unexpected(run.error());
  }
  printMapNotes(console.errors, (*run)->map().get());
  const bool connected = drive(**run, numberOf(values, kSecondsField), console);
  const json figures = realFigures(**run, connected);
  run->reset();
  const ExitStatus recorded = *recorder ? finishRecording(**recorder, console.errors) : kDone;
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), connected ? recorded : kFailed};
}

RealRobotOptions robotOf(const RealHeadless& declared, const HeadlessChoices& choices) {
  const FormValues& values = choices.options.values;
  RealRobotOptions options = declared.robotOf(choices.platform, values);
  options.robot = textOf(values, kRobotField, options.robot);
  applyChoices(choices, options.program);
  return options;
}

robotlink::Result<HeadlessServing> prepareServedReal(const RealHeadless& declared,
                                                     const HeadlessChoices& choices,
                                                     const HeadlessConsole& console) {
  RealRobotOptions options = robotOf(declared, choices);
  options.program.spreadReport = printSpread(console);
  return servingOf(RealFeed::opening(std::move(options)), choices);
}

robotlink::Result<HeadlessPlatform::Run> prepareReal(const RealHeadless& declared,
                                                     const HeadlessChoices& choices) {
  return [options = robotOf(declared, choices), choices](const HeadlessConsole& console) {
    RealRobotOptions reporting = options;
    reporting.program.spreadReport = printSpread(console);
    return runReal(reporting, choices, console);
  };
}

std::filesystem::path layoutOf(const RealHeadless& declared, const HeadlessChoices& choices) {
  const RealRobotOptions options = robotOf(declared, choices);
  if (!options.program.layout.empty()) return options.program.layout;
  const auto description = readRobot(options.kind);
  return description ? layoutFile(**description) : std::filesystem::path();
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherOfReal(const RealRobotOptions& options,
                                                                const HeadlessChoices& choices,
                                                                const HeadlessConsole& console) {
  auto layout = readLayoutWith(options.program.layout, options.program.solutions);
  if (!layout) return tl::unexpected(layout.error());
  auto robot = hostedRobot(options);
  if (!robot) return tl::unexpected(robot.error());
  // An invalid address is reported here, before anything is opened.
  const robotlink::SteadyClock probe;
  if (const auto platform = options.platform(probe, options.robot, *robot->description); !platform)
    return tl::unexpected(robotlink::Errors{platform.error()});
  const auto description = robot->description;
  return runOtherProgram(
      {.robot = std::move(*robot),
       .layout = std::move(*layout),
       .options = options.program.spread,
       .platform = [&](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
         return std::move(options.platform(clock, options.robot, *description)).value();
       },
       .report = {}},
      choices, console);
}

robotlink::Result<HeadlessPlatform::Run> prepareOtherOfReal(const RealHeadless& declared,
                                                            const HeadlessChoices& choices) {
  RealRobotOptions options = robotOf(declared, choices);
  options.program.layout = layoutOf(declared, choices);
  return [options, choices](const HeadlessConsole& console) {
    return runOtherOfReal(options, choices, console);
  };
}

}  // namespace

HeadlessPlatform headlessReal(RealHeadless declared) {
  std::vector<PlatformField> options = headlessRobotFields(declared.robot);
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
              [shared](const HeadlessChoices& choices) { return prepareOtherOfReal(*shared, choices); }};
}

}  // namespace app
