// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/HeadlessRobot.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/RobotName.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/ShippedFiles.h"

namespace app {

using nlohmann::json;
using Kind = PlatformField::Kind;

std::vector<PlatformField> headlessRobotFields(const std::string& robot) {
  const std::string usual = robot.empty() ? "" : " (" + robot + ")";
  return {{.name = kMapField, .help = "Robots: a map (.map) of the area where it drives", .option = "--map"},
          {.name = kRobotField, .help = "Robots: its name" + usual, .option = "--robot", .check = robotName},
          {.name = kSecondsField,
           .kind = Kind::kNumber,
           .help = "Robots: how long it runs (until Ctrl-C)",
           .initial = 0.0,
           .noun = "duration",
           .max = 1e6,
           .decimals = 3,
           .unit = "s",
           .option = "--seconds"},
          {.name = kTextsField,
           .kind = Kind::kFlag,
           .help = "Robots: prints the program's text messages on stderr",
           .initial = false,
           .option = "--texts"},
          {.name = kTeamPortField,
           .kind = Kind::kNumber,
           .help = "Robots: the UDP port at which it hears its team (none)",
           .initial = 0.0,
           .noun = "port",
           .max = 65535,
           .option = "--team-port"},
          {.name = kTeamPeersField,
           .help = "Robots: the others of its team, HOST:PORT, comma-separated; a broadcast address reaches "
                   "a whole network",
           .option = "--team-peers"},
          {.name = kTeamField, .help = "Robots: the name of its team", .option = "--team"},
          ownProcessField()};
}

namespace {

/// Returns the options of the team link; disabled unless a port was chosen.
TeamLinkOptions teamOf(const FormValues& values) {
  TeamLinkOptions team{.team = textOf(values, kTeamField)};
  const double port = numberOf(values, kTeamPortField);
  if (port > 0) team.port = static_cast<std::uint16_t>(port);
  std::istringstream stream(textOf(values, kTeamPeersField));
  for (std::string peer; std::getline(stream, peer, ',');)
    if (!peer.empty()) team.peers.push_back(peer);
  return team;
}

}  // namespace

void applyChoices(const HeadlessChoices& choices, RealTimeOptions& program) {
  const FormValues& values = choices.options.values;
  if (!choices.layout.empty()) program.layout = layoutNamed(choices.layout);
  program.map = textOf(values, kMapField);
  for (const auto& [task, solution] : choices.solutions) program.solutions[task] = solution;
  program.preset = withShadows(choices.preset, choices.shadows);
  program.team = teamOf(values);
  program.spread = choices.spread;
  program.hosting.ownProcesses = flagOf(values, ownProcessField().name);
}

std::function<void(const std::string& text)> printSpread(const HeadlessConsole& console) {
  return [&console](const std::string& text) { console.errors << text + "\n" << std::flush; };
}

HeadlessServing servingOf(PlatformOpening opening, const HeadlessChoices& choices) {
  const FormValues& values = choices.options.values;
  HeadlessServing serving{std::move(opening)};
  if (const double seconds = numberOf(values, kSecondsField); seconds > 0) serving.seconds = seconds;
  serving.texts = flagOf(values, kTextsField);
  return serving;
}

std::string figuresText(const json& figures) {
  std::string text;
  for (const auto& [name, value] : figures.items())
    text += fmt::format("{:<24}{}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

tl::expected<HeadlessSummary, robotlink::Errors> runOtherProgram(OtherProgram::Parts parts,
                                                                 const HeadlessChoices& choices,
                                                                 const HeadlessConsole& console) {
  const std::string name = parts.options.program;
  parts.report = printSpread(console);
  const auto program = OtherProgram::create(std::move(parts));
  if (!program) return tl::unexpected(program.error());
  const bool heard = (*program)->run(numberOf(choices.options.values, kSecondsField), console.interrupted);
  const json figures = {{"program", name}, {"heard", heard}};
  return HeadlessSummary{jsonOutput(figures), figuresText(figures), heard ? kDone : kFailed};
}

}  // namespace app
