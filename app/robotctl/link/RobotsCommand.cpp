// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl robots`: the robots that announce themselves on the networks of this machine.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "robotlink/dds/RobotDiscovery.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kDiscoveryLook{50};

struct RobotsArguments {
  double seconds = 3;
  std::string address;
};

int listRobots(const RobotsArguments& arguments) {
  auto nodes = robotlink::dds::announcementNodes(arguments.address);
  if (nodes.empty()) {
    return printErrors({{"robots.network",
                         "this machine has no network interface on which robots could announce themselves; "
                         "those on the loopback interface do not",
                         {},
                         {}}});
  }
  const auto discovery = robotlink::dds::RobotDiscovery::open(std::move(nodes));
  if (!discovery) return printErrors({discovery.error()});
  const Interrupt interrupt;
  const auto end = std::chrono::steady_clock::now() + robotlink::fromSeconds(arguments.seconds);
  while (!Interrupt::noted() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(kDiscoveryLook);
  for (const auto& robots : (*discovery)->robots()) {
    std::string names;
    for (const auto& robot : robots.robots) {
      const std::string runs = robot.isBody           ? ", only its body"
                               : robot.layout.empty() ? std::string()
                                                      : ", layout " + robot.layout;
      const std::string what = robot.kind.empty() ? std::string() : " (" + robot.kind + runs + ")";
      names += (names.empty() ? "" : ", ") + robot.name + what;
    }
    std::cout << robots.url() << "  " << names;
    if (robots.isEncrypted) std::cout << "  fingerprint " << robots.fingerprint;
    std::cout << '\n';
  }
  return kDone;
}

}  // namespace

void addRobotsCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<RobotsArguments>();
  CLI::App* command =
      app.add_subcommand("robots",
                         "Lists robots that announce themselves on this machine's networks: those started "
                         "with --listen ADDRESS:PORT");
  command->add_option("--seconds", arguments->seconds, "How long to listen, s")
      ->check(numberFrom(0.1, 3600))
      ->capture_default_str();
  command->add_option("--interface", arguments->address,
                      "The address of the network interface to listen on (all)");
  command->callback([arguments, &status] { status = listRobots(*arguments); });
}

}  // namespace app
