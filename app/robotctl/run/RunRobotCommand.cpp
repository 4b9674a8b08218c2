// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/RunRobotCommand.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/pioneer/PioneerRun.h"
#include "app/core/program/ShippedFiles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/JsonOutput.h"
#include "app/robotctl/run/TextMessages.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace app {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds kStep{10};

PioneerRun::Listeners robotListeners(const RunRobotArguments& arguments) {
  PioneerRun::Listeners listeners;
  listeners.trouble = [](const std::string& robot, const robotlink::Process&, const std::string& text) {
    std::cerr << robot << ": " << text << "\n";
  };
  if (arguments.texts) {
    listeners.queue = [](const std::string& robot, const auto& queue) { printTexts(robot, *queue); };
    listeners.platform = [](const std::string& robot, robotlink::Instant, const std::string& text) {
      std::cerr << robot << ": " << text << "\n";
    };
  }
  return listeners;
}

/// Steps the run until its end and prints changes of the connection. Returns whether the robot was ever
/// connected.
bool drive(PioneerRun& run, const RunRobotArguments& arguments) {
  const robotlink::Instant end = run.clock().now() + robotlink::fromSeconds(arguments.seconds);
  std::string reported;
  bool connected = false;
  auto due = std::chrono::steady_clock::now();
  while (!Interrupt::noted() && (arguments.seconds == 0 || run.clock().now() < end)) {
    run.step();
    const auto& session = run.platform().driver().session();
    connected = connected || session.isConnected();
    if (const std::string text = session.describe(); text != reported) {
      std::cerr << std::fixed << std::setprecision(3) << robotlink::seconds(run.clock().now()) << "  " << text
                << "\n";
      reported = text;
    }
    due += kStep;
    std::this_thread::sleep_until(due);
  }
  return connected;
}

json figuresOf(const PioneerRun& run, bool connected) {
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

}  // namespace

bool isRobotAddress(const std::string& platform) {
  if (platform.starts_with("tcp://") || platform.starts_with("serial://")) return true;
  if (platform.starts_with("log:") || (platform.starts_with('/') && !platform.starts_with("/dev/")))
    return false;
  return robotlink::arcos::parseUrl(platform).has_value();
}

int runRobot(const RunRobotArguments& arguments) {
  PioneerOptions options{.url = arguments.url, .robot = arguments.robot};
  if (!arguments.layout.empty()) options.layout = layoutNamed(arguments.layout);
  options.map = arguments.map;
  options.solutions = arguments.solutions;
  options.motorsOn = arguments.motorsOn;
  const Interrupt interrupt;
  const auto recorder = arguments.record.start();
  if (!recorder) return printErrors({recorder.error()});
  auto run = PioneerRun::create(std::move(options), robotListeners(arguments), recorder->get());
  if (!run) {
    std::error_code ignored;
    if (*recorder) std::filesystem::remove(arguments.record.file, ignored);
    return printErrors(run.error());
  }
  printMapNotes((*run)->map().get());
  const bool connected = drive(**run, arguments);
  const json figures = figuresOf(**run, connected);
  run->reset();
  const int recorded = *recorder ? finishRecording(**recorder) : kDone;
  if (arguments.asJson) {
    std::cout << jsonOutput(figures);
  } else {
    for (const auto& [name, value] : figures.items()) {
      std::cout << std::left << std::setw(24) << name
                << (value.is_string() ? value.get<std::string>() : value.dump()) << "\n";
    }
  }
  return connected ? recorded : kFailed;
}

}  // namespace app
