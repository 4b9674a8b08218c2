// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl deploy`: the files that robots of a set should have.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/deploy/Deployment.h"
#include "app/core/platform/ExitStatus.h"
#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/RecordingFetch.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/link/LinkOptions.h"
#include "robotlink/base/Printable.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"

namespace app {
namespace {

using robotlink::websocket::Client;
using robotlink::websocket::ConnectionState;
using robotlink::websocket::Connector;
using Differences = std::vector<DeployDifference>;

struct DeployArguments {
  std::string file, token;
  std::vector<std::string> robots;
  bool checks = false, restarts = false, asJson = false;
};

/// Whether there is a connection within a few seconds; why not is in the client's state.
bool becomesConnected(const Client& client) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < end && !Interrupt::noted()) {
    const auto phase = client.state().phase;
    if (phase == ConnectionState::Phase::kConnected) return true;
    if (phase == ConnectionState::Phase::kRefused) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

robotlink::Result<Differences> deployTo(const RobotSet::Robot& robot, const std::vector<DeployFile>& files,
                                        const DeployArguments& arguments) {
  const LinkOptions link{robot.address, arguments.token};
  const auto connection = link.connection();
  if (!connection) return tl::unexpected(connection.error());
  const auto client = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  const Connector connector(client, *connection);
  if (!becomesConnected(*client))
    return robotlink::failure("deploy.link", toString(connection->url) + ": " + client->state().reason);
  Deployment deployment(callsOf(*client), robot.name);
  const auto proceed = [](double) { return !Interrupt::noted(); };
  auto done = arguments.checks ? deployment.check(files, proceed) : deployment.send(files, proceed);
  return done && arguments.restarts ? deployment.restart(files, proceed) : done;
}

nlohmann::json jsonOf(const RobotSet::Robot& robot, const robotlink::Result<Differences>& done) {
  nlohmann::json result{{"robot", robot.name}};
  if (!done) {
    result["error"] = done.error().describe();
    return result;
  }
  result["files"] = nlohmann::json::array();
  for (const DeployDifference& one : *done) {
    const char* states[] = {"same", "differs", "missing", "waiting"};
    result["files"].push_back({{"path", one.path}, {"state", states[static_cast<int>(one.state)]}});
  }
  return result;
}

/// All robots of the set, or those that were named.
robotlink::Result<std::vector<RobotSet::Robot>> chosenFrom(const RobotSet& set,
                                                           const std::vector<std::string>& names) {
  if (names.empty()) return set.robots;
  std::vector<RobotSet::Robot> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(set.robots, name, &RobotSet::Robot::name);
    if (found == set.robots.end())
      return robotlink::failure("deploy.robot", "there is no robot '" + name + "' in this set", {}, {name});
    chosen.push_back(*found);
  }
  return chosen;
}

int runDeploy(const DeployArguments& arguments) {
  const auto set = readRobotSet(arguments.file);
  if (!set) return printErrors(set.error());
  const auto robots = chosenFrom(*set, arguments.robots);
  if (!robots) return printErrors({robots.error()});
  const auto folder = std::filesystem::path(arguments.file).parent_path();
  // Reads all files first, so that nothing is sent if one of them is missing.
  std::vector<std::vector<DeployFile>> files;
  robotlink::Errors errors;
  for (const auto& robot : *robots) {
    auto found = filesFor(robot, folder);
    if (!found) errors.insert(errors.end(), found.error().begin(), found.error().end());
    files.push_back(found ? *std::move(found) : std::vector<DeployFile>());
  }
  if (!errors.empty()) return printErrors(errors);
  const Interrupt interrupt;
  int status = kDone;
  bool waits = false;
  nlohmann::json all = nlohmann::json::array();
  for (std::size_t i = 0; i < robots->size() && !Interrupt::noted(); ++i) {
    const auto& robot = (*robots)[i];
    const auto done = deployTo(robot, files[i], arguments);
    using State = DeployDifference::State;
    const bool isSame = done && std::ranges::all_of(*done, [](const auto& one) {
                          return one.state == State::kSame || one.state == State::kWaiting;
                        });
    if (!isSame) status = kFailed;
    all.push_back(jsonOf(robot, done));
    if (arguments.asJson) continue;
    (done ? std::cout : std::cerr) << robot.name << ": "
                                   << robotlink::printable(done ? describe(*done) : done.error().describe())
                                   << std::endl;
    waits = waits || (done && needsRestart(*done));
  }
  if (waits && !arguments.asJson)
    std::cerr << "Restart the programs when the robots may stop: robotctl deploy " << arguments.file
              << " --restart" << std::endl;
  if (arguments.asJson) std::cout << jsonOutput(all);
  return status;
}

}  // namespace

void addDeployCommand(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<DeployArguments>();
  CLI::App* command = app.add_subcommand(
      "deploy", "Sends layout, color table, parameters, motions and preset to the robots of a set");
  command->add_option("set", arguments->file, "The set: a YAML file, as Robot > Robots... writes it")
      ->required()
      ->type_name("SET.yaml");
  auto* checks =
      command->add_flag("--check", arguments->checks,
                        "Sends nothing, but lists what differs; the exit status is 1 if anything does");
  command
      ->add_flag(
          "--restart", arguments->restarts,
          "Then restarts programs that have not read all of it yet; these robots are stopped meanwhile")
      ->excludes(checks);
  command->add_option("--robot", arguments->robots, "Only this robot; may be repeated");
  command->add_option("--token", arguments->token, "The robots' token; default: the remembered ones")
      ->envname("ROBOTCONTROL_TOKEN");
  command->add_flag("--json", arguments->asJson, "Prints JSON");
  command->callback([arguments, &status] { status = runDeploy(*arguments); });
}

}  // namespace app
