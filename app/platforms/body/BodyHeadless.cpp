// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyHeadless.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/body/BodyFeed.h"
#include "app/platforms/body/BodyStandIn.h"
#include "app/platforms/real/HeadlessRobot.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = PlatformField::Kind;

constexpr char kTokenOption[] = "token", kJpegOption[] = "jpeg", kPngOption[] = "png",
               kBudgetOption[] = "budget", kRateOption[] = "image-rate";
constexpr robotlink::StreamStore::Limits kNoHistory{std::chrono::seconds(1), 64U << 20U};

BodyOptions bodyOptionsOf(const HeadlessChoices& choices, const HeadlessConsole& console) {
  const FormValues& values = choices.options.values;
  const char* token = std::getenv("ROBOTCONTROL_TOKEN");
  BodyOptions options{.url = choices.platform};
  options.isTrusted = trustAndPrint(console.errors);
  options.token = textOf(values, kTokenOption, token != nullptr ? token : "");
  options.robot = textOf(values, kRobotField);
  applyChoices(choices, options.program);
  options.limits.bytesPerSecond = numberOf(values, kBudgetOption);
  options.limits.imagesPerSecond = numberOf(values, kRateOption);
  if (flagOf(values, kJpegOption)) options.limits.images = LinkLimits::Images::kJpeg;
  if (flagOf(values, kPngOption)) options.limits.images = LinkLimits::Images::kPng;
  return options;
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

/// Prints texts: those of the platform always, those of the program only if `all`.
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
                         printBodyText(console.errors, message, flagOf(values, kTextsField));
                       },
                       {}});
  auto feed = BodyFeed::create(options, session, *recorder ? **recorder : none);
  if (!feed) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(choices.record.file, ignored);
    return tl::unexpected(feed.error());
  }
  (*feed)->begin();
  const double seconds = numberOf(values, kSecondsField);
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
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), recorded};
}

robotlink::Result<HeadlessServing> prepareServedBody(const HeadlessChoices& choices,
                                                     const HeadlessConsole& console) {
  BodyOptions options = bodyOptionsOf(choices, console);
  options.program.spreadReport = printSpread(console);
  return servingOf(BodyFeed::opening(std::move(options)), choices);
}

robotlink::Result<HeadlessPlatform::Run> prepareBody(const HeadlessChoices& choices) {
  return [choices](const HeadlessConsole& console) {
    BodyOptions reporting = bodyOptionsOf(choices, console);
    reporting.program.spreadReport = printSpread(console);
    return runBody(reporting, choices, console);
  };
}

std::filesystem::path bodyLayoutOf(const HeadlessChoices& choices) {
  return choices.layout.empty() ? std::filesystem::path() : layoutNamed(choices.layout);
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherOfBody(const HeadlessChoices& choices,
                                                                const HeadlessConsole& console) {
  const BodyOptions options = bodyOptionsOf(choices, console);
  auto layout = readLayoutWith(options.program.layout, options.program.solutions);
  if (!layout) return tl::unexpected(layout.error());
  const auto body = BodyFeed::find(options);
  if (!body) return tl::unexpected(body.error());
  return runOtherProgram(
      {.robot = body->robot,
       .layout = std::move(*layout),
       .options = options.program.spread,
       .platform = [&](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
         return std::make_unique<BodyStandIn>(body->offer, clock);
       },
       .report = {}},
      choices, console);
}

robotlink::Result<HeadlessPlatform::Run> prepareOtherOfBody(const HeadlessChoices& choices) {
  return [choices](const HeadlessConsole& console) { return runOtherOfBody(choices, console); };
}

}  // namespace

HeadlessPlatform headlessBody() {
  std::vector<PlatformField> options = headlessRobotFields({});
  const std::vector<PlatformField> ofBodies{
      {.name = kTokenOption,
       .help = "Remote bodies: the token printed there "
               "($ROBOTCONTROL_TOKEN); default: the remembered one",
       .option = "--token"},
      {.name = kJpegOption,
       .kind = Kind::kFlag,
       .help = "Remote bodies: images as JPEG, for slow links",
       .initial = false,
       .option = "--jpeg"},
      {.name = kPngOption,
       .kind = Kind::kFlag,
       .help = "Remote bodies: images as PNG",
       .initial = false,
       .option = "--png"},
      {.name = kBudgetOption,
       .kind = Kind::kNumber,
       .help = "Remote bodies: bytes per second that the body may send (no limit)",
       .initial = 0.0,
       .noun = "number of bytes a second",
       .max = 1e12,
       .option = "--budget"},
      {.name = kRateOption,
       .kind = Kind::kNumber,
       .help = "Remote bodies: images per second of each stream that the body may send (all)",
       .initial = 0.0,
       .noun = "number of images a second",
       .max = 1e6,
       .option = "--image-rate"}};
  options.insert(options.end(), ofBodies.begin(), ofBodies.end());
  return {.help = "a remote body, offered by 'robotctl platform ... --listen': ws://HOST[:PORT]",
          .usage = "a remote body: ws://HOST:PORT",
          .options = std::move(options),
          .prepare = prepareBody,
          .prepareServing = prepareServedBody,
          .layoutOf = bodyLayoutOf,
          .prepareOther = prepareOtherOfBody};
}

}  // namespace app
