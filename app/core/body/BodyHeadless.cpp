// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/body/BodyHeadless.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/body/BodyFeed.h"
#include "app/core/body/BodyStandIn.h"
#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/spread/OtherProgram.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = PlatformField::Kind;

constexpr char kMapOption[] = "map", kRobotOption[] = "robot", kSecondsOption[] = "seconds",
               kTextsOption[] = "texts", kTokenOption[] = "token", kJpegOption[] = "jpeg",
               kPngOption[] = "png", kBudgetOption[] = "budget", kRateOption[] = "image-rate";
constexpr robotlink::StreamStore::Limits kNoHistory{std::chrono::seconds(1), 64U << 20U};

BodyOptions bodyOptionsOf(const HeadlessChoices& choices, const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const char* token = std::getenv("ROBOTCONTROL_TOKEN");
  BodyOptions options{.url = choices.platform};
  options.isTrusted = trustAndPrint(console.errors);
  options.token = textOf(values, kTokenOption, token != nullptr ? token : "");
  options.robot = textOf(values, kRobotOption);
  if (!choices.layout.empty()) options.layout = layoutNamed(choices.layout);
  options.map = textOf(values, kMapOption);
  options.solutions = choices.solutions;
  options.limits.bytesPerSecond = numberOf(values, kBudgetOption);
  options.limits.imagesPerSecond = numberOf(values, kRateOption);
  if (flagOf(values, kJpegOption)) options.limits.images = LinkLimits::Images::kJpeg;
  if (flagOf(values, kPngOption)) options.limits.images = LinkLimits::Images::kPng;
  options.spread = choices.spread;
  options.hosting.ownProcesses = flagOf(values, ownProcessField().name);
  return options;
}

/// Prints what concerns the links between programs, which users should see without asking for it.
std::function<void(const std::string& text)> bodySpreadReport(const HeadlessConsole& console) {
  return [&console](const std::string& text) { console.errors << text + "\n" << std::flush; };
}

json bodyFigures(const BodyFeed& feed, double seconds) {
  const auto& counts = feed.platform().counts();
  const LoadedPlatform loaded = feed.describe();
  const auto state = feed.link().state();
  return {{"address", loaded.sources.front()},
          {"robot", loaded.robots.begin()->first},
          {"layout", loaded.layout.string()},
          {"real_seconds", seconds},
          {"frames", counts.frames},
          {"commands", counts.commands},
          {"obeyed_commands", counts.obeyed},
          {"late_commands", counts.late},
          {"cuts", counts.cuts},
          {"round_trip_s", state.roundTrip ? robotlink::seconds(*state.roundTrip) : 0.0},
          {"longest_gap_s", robotlink::seconds(counts.longestSilence)}};
}

std::string bodyFiguresText(const json& figures) {
  std::string text;
  for (const auto& [name, value] : figures.items())
    text += fmt::format("{:<24}{}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

/// Prints texts: those of the platform always, those of the program if they are wanted.
void printBodyText(std::ostream& out, const robotlink::StreamMessage& message, bool all) {
  const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
  if (text == nullptr || !(all || text->name() == "platform")) return;
  printText(out, message.time, message.path.substr(0, message.path.find('/')) + "/" + text->name(),
            text->message());
}

tl::expected<HeadlessSummary, robotlink::Errors> runBody(const BodyOptions& options,
                                                         const HeadlessChoices& choices,
                                                         const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const auto recorder = choices.record.start();
  if (!recorder) return tl::unexpected(robotlink::Errors{recorder.error()});
  logplayer::Recorder none({});
  robotlink::Session session(kNoHistory);
  session.addListener({[&](const robotlink::StreamMessage& message) {
                         printBodyText(console.errors, message, flagOf(values, kTextsOption));
                       },
                       {}});
  auto feed = BodyFeed::create(options, session, *recorder ? **recorder : none);
  if (!feed) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(choices.record.file, ignored);
    return tl::unexpected(feed.error());
  }
  (*feed)->begin();
  const double seconds = numberOf(values, kSecondsOption);
  const auto begin = std::chrono::steady_clock::now();
  const auto taken = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (!console.interrupted() && (seconds == 0 || taken() < seconds)) {
    (*feed)->step();
    session.tick();
    std::this_thread::sleep_until((*feed)->due().value_or(begin));
  }
  const json figures = bodyFigures(**feed, taken());
  feed->reset();
  const ExitStatus recorded = *recorder ? finishRecording(**recorder, console.errors) : kDone;
  return HeadlessSummary{jsonOutput(figures), bodyFiguresText(figures), recorded};
}

robotlink::Result<HeadlessServing> prepareServedBody(const HeadlessChoices& choices,
                                                     const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  BodyOptions options = bodyOptionsOf(choices, console);
  options.spreadReport = bodySpreadReport(console);
  HeadlessServing serving{BodyFeed::opening(std::move(options))};
  if (const double seconds = numberOf(values, kSecondsOption); seconds > 0) serving.seconds = seconds;
  serving.texts = flagOf(values, kTextsOption);
  return serving;
}

robotlink::Result<HeadlessPlatform::Run> prepareBody(const HeadlessChoices& choices) {
  return [choices](const HeadlessConsole& console) {
    BodyOptions reporting = bodyOptionsOf(choices, console);
    reporting.spreadReport = bodySpreadReport(console);
    return runBody(reporting, choices, console);
  };
}

std::filesystem::path bodyLayoutOf(const HeadlessChoices& choices) {
  return choices.layout.empty() ? std::filesystem::path() : layoutNamed(choices.layout);
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherOfBody(const BodyOptions& options, double seconds,
                                                                const HeadlessConsole& console) {
  auto layout = readLayoutWith(options.layout, options.solutions);
  if (!layout) return tl::unexpected(layout.error());
  const auto body = BodyFeed::find(options);
  if (!body) return tl::unexpected(body.error());
  const auto program = OtherProgram::create(
      {.robot = body->robot,
       .layout = std::move(*layout),
       .options = options.spread,
       .platform = [&](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
         return std::make_unique<BodyStandIn>(body->offer, clock);
       },
       .report = bodySpreadReport(console)});
  if (!program) return tl::unexpected(program.error());
  const bool heard = (*program)->run(seconds, console.interrupted);
  const json figures = {{"program", options.spread.program}, {"heard", heard}};
  return HeadlessSummary{jsonOutput(figures), bodyFiguresText(figures), heard ? kDone : kFailed};
}

robotlink::Result<HeadlessPlatform::Run> prepareOtherOfBody(const HeadlessChoices& choices) {
  return [choices](const HeadlessConsole& console) {
    return runOtherOfBody(bodyOptionsOf(choices, console), numberOf(choices.options.values, kSecondsOption),
                          console);
  };
}

}  // namespace

HeadlessPlatform headlessBody() {
  return {
      .help = "a body that is elsewhere, where 'robotctl platform ... --listen' runs: ws://HOST[:PORT]",
      .usage = "a body elsewhere: ws://HOST:PORT",
      .options =
          {{.name = kMapOption, .help = "Robots: a map (.map) of where it drives", .option = "--map"},
           {.name = kRobotOption, .help = "Robots: its name", .option = "--robot", .check = robotName},
           {.name = kSecondsOption,
            .kind = Kind::kNumber,
            .help = "Robots: how long it runs (until Ctrl-C)",
            .initial = 0.0,
            .noun = "duration",
            .max = 1e6,
            .option = "--seconds"},
           {.name = kTextsOption,
            .kind = Kind::kFlag,
            .help = "Robots: prints the program's text messages on stderr",
            .initial = false,
            .option = "--texts"},
           {.name = kTokenOption,
            .help = "Bodies elsewhere: the token that was printed there ($ROBOTCONTROL_TOKEN); without one "
                    "that which is remembered",
            .option = "--token"},
           {.name = kJpegOption,
            .kind = Kind::kFlag,
            .help = "Bodies elsewhere: images as JPEG, for narrow lines",
            .initial = false,
            .option = "--jpeg"},
           {.name = kPngOption,
            .kind = Kind::kFlag,
            .help = "Bodies elsewhere: images as PNG",
            .initial = false,
            .option = "--png"},
           {.name = kBudgetOption,
            .kind = Kind::kNumber,
            .help = "Bodies elsewhere: bytes a second that the body may send (no limit)",
            .initial = 0.0,
            .noun = "number of bytes a second",
            .max = 1e12,
            .option = "--budget"},
           {.name = kRateOption,
            .kind = Kind::kNumber,
            .help = "Bodies elsewhere: images of each stream a second that the body may send (all)",
            .initial = 0.0,
            .noun = "number of images a second",
            .max = 1e6,
            .option = "--image-rate"},
           ownProcessField()},
      .prepare = prepareBody,
      .prepareServing = prepareServedBody,
      .layoutOf = bodyLayoutOf,
      .prepareOther = prepareOtherOfBody};
}

}  // namespace app
