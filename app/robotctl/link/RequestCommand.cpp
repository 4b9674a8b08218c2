// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl request`.
#include <CLI/CLI.hpp>
#include <chrono>
#include <future>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/NumberRange.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/link/LinkOptions.h"
#include "robotlink/base/Printable.h"
#include "robotlink/base/Spelling.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::websocket::Client;
using robotlink::websocket::ConnectionState;
using robotlink::websocket::Connector;
using Answer = robotlink::Result<Client::Answer>;

struct RequestArguments {
  LinkOptions link;
  std::string service, argument;
  double seconds = 10;
};

constexpr std::chrono::milliseconds kLookInterval{5};

/// Waits until the condition holds or the time is over; false if it does not hold, or the user interrupted.
template <typename Condition>
bool waitFor(Condition condition, std::chrono::steady_clock::time_point end) {
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end || Interrupt::noted()) return false;
    std::this_thread::sleep_for(kLookInterval);
  }
  return true;
}

int printProblem(const std::string& text) {
  std::cerr << robotlink::printable(text) << "\n";
  return kFailed;
}

/// Services are announced together, with or shortly after the first message.
bool hasServices(const Client& client) {
  return client.state().isConnected() && !client.services().empty();
}

int listServices(const Client& client) {
  for (const auto& service : client.services())
    std::cout << robotlink::printable(service.name + "  " + service.type) << "\n";
  return kDone;
}

int printUnknown(const Client& client, const std::string& wanted) {
  std::vector<std::string> names;
  for (const auto& service : client.services()) names.push_back(service.name);
  const std::string near = robotlink::nearest(wanted, names);
  return printProblem(
      "the robot offers no service '" + wanted + "'" +
      (near.empty() ? "; 'robotctl request URL' lists them all" : "; did you mean '" + near + "'?"));
}

/// A robot of ours says whether it accepts; any other answer is one.
int printAnswer(const Client::Answer& answer) {
  const json parsed = json::parse(answer.data, nullptr, false);
  if (parsed.is_discarded()) {
    std::cout << robotlink::printableLines(answer.data) << "\n";
    return kDone;
  }
  std::cout << jsonOutput(parsed);
  const bool isRefused = parsed.is_object() && parsed.contains("accepted") && parsed["accepted"] == false;
  if (isRefused)
    std::cerr << robotlink::printable("refused: " +
                                      parsed.value("reason", std::string("no reason was given")))
              << "\n";
  return isRefused ? kFailed : kDone;
}

int callService(Client& client, const RequestArguments& arguments,
                std::chrono::steady_clock::time_point end) {
  const auto services = client.services();
  const auto isWanted = [&](const auto& service) { return service.name == arguments.service; };
  if (std::ranges::none_of(services, isWanted)) return printUnknown(client, arguments.service);
  Client::Call call;
  call.service = arguments.service;
  call.encoding = "json";
  call.payload = arguments.argument.empty() ? "{}" : arguments.argument;
  call.answerTime = robotlink::fromSeconds(arguments.seconds);
  if (call.service.ends_with("/stop")) call.urgency = Client::Urgency::kUrgent;
  const auto promise = std::make_shared<std::promise<Answer>>();
  auto answer = promise->get_future();
  client.call(std::move(call), [promise](const Answer& got) { promise->set_value(got); });
  const auto isReady = [&] { return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready; };
  if (!waitFor(isReady, end + std::chrono::seconds(1))) return printProblem("there was no answer");
  const Answer got = answer.get();
  return got ? printAnswer(*got) : printProblem(got.error().text);
}

int request(const RequestArguments& arguments) {
  const auto connection = arguments.link.connection();
  if (!connection) {
    printErrors({connection.error()});
    return kUsage;
  }
  if (!arguments.argument.empty() && !json::accept(arguments.argument)) {
    std::cerr << "robotctl request: the argument is not JSON: write it as '{\"name\": \"value\"}'\n";
    return kUsage;
  }
  const Interrupt interrupt;
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                             std::chrono::duration<double>(arguments.seconds));
  const auto client = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  const Connector connector(client, *connection);
  const auto isOver = [&] {
    return hasServices(*client) || client->state().phase == ConnectionState::Phase::kRefused;
  };
  if (!waitFor(isOver, end) || !hasServices(*client)) {
    const ConnectionState state = client->state();
    const std::string why = state.isConnected() ? "it offers no services" : state.reason;
    return printProblem(toString(connection->url) + ": " + (why.empty() ? "it does not answer" : why));
  }
  return arguments.service.empty() ? listServices(*client) : callService(*client, arguments, end);
}

}  // namespace

void addRequestCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<RequestArguments>();
  CLI::App* command = app.add_subcommand("request", "Calls a service of a remote robot by its name");
  arguments->link.addTo(*command);
  command->add_option("service", arguments->service,
                      "The service, such as red1/set_key; without it, all services are listed");
  command->add_option("argument", arguments->argument,
                      R"(Its argument as JSON: '{"name": "ball-percept/disc", "mode": {"kind": "ALWAYS"}}')");
  command->add_option("--seconds", arguments->seconds, "Time to wait for the connection and for the answer")
      ->check(numberFrom(0.1, 3600))
      ->capture_default_str();
  command->footer(
      "Prints the answer as JSON. Exit status: 0 accepted, 1 refused or not answered, 2 wrong usage.");
  command->callback([arguments, &status] { status = request(*arguments); });
}

}  // namespace app
