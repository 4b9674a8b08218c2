// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/body/BodyHeadless.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/body/BodyFeed.h"
#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/platform/TextMessages.h"
#include "app/core/program/ShippedFiles.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = PlatformField::Kind;

constexpr char kMapOption[] = "map", kRobotOption[] = "robot", kSecondsOption[] = "seconds",
               kTextsOption[] = "texts", kTokenOption[] = "token", kJpegOption[] = "jpeg";
constexpr robotlink::StreamStore::Limits kNoHistory{std::chrono::seconds(1), 64U << 20U};

BodyOptions bodyOptionsOf(const HeadlessChoices& choices) {
  const FormValues& values = choices.options.values;
  const char* token = std::getenv("ROBOTCONTROL_TOKEN");
  BodyOptions options{.url = choices.platform};
  options.token = textOf(values, kTokenOption, token != nullptr ? token : "");
  options.robot = textOf(values, kRobotOption);
  if (!choices.layout.empty()) options.layout = layoutNamed(choices.layout);
  options.map = textOf(values, kMapOption);
  options.solutions = choices.solutions;
  options.asJpeg = flagOf(values, kJpegOption);
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

robotlink::Result<HeadlessServing> prepareServedBody(const HeadlessChoices& choices, const HeadlessConsole&) {
  const FormValues& values = choices.options.values;
  HeadlessServing serving{BodyFeed::opening(bodyOptionsOf(choices))};
  if (const double seconds = numberOf(values, kSecondsOption); seconds > 0) serving.seconds = seconds;
  serving.texts = flagOf(values, kTextsOption);
  return serving;
}

robotlink::Result<HeadlessPlatform::Run> prepareBody(const HeadlessChoices& choices) {
  return [options = bodyOptionsOf(choices), choices](const HeadlessConsole& console) {
    return runBody(options, choices, console);
  };
}

}  // namespace

HeadlessPlatform headlessBody() {
  return {
      .help = "a body that is elsewhere, where 'robotctl platform ... --listen' runs: ws://HOST[:PORT]",
      .usage = "a body elsewhere: ws://HOST:PORT",
      .options = {{.name = kMapOption, .help = "Robots: a map (.map) of where it drives", .option = "--map"},
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
                   .help = "Bodies elsewhere: the token that was printed there ($ROBOTCONTROL_TOKEN)",
                   .option = "--token"},
                  {.name = kJpegOption,
                   .kind = Kind::kFlag,
                   .help = "Bodies elsewhere: images as JPEG, for narrow lines",
                   .initial = false,
                   .option = "--jpeg"}},
      .prepare = prepareBody,
      .prepareServing = prepareServedBody};
}

}  // namespace app
