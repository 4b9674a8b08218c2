// SPDX-License-Identifier: GPL-3.0-or-later
// A controller of a simulation as a program of its own: lets a robot on wheels wander without hitting
// anything.
//
//     robotctl sim pioneer --listen 8765 &
//     wander ws://127.0.0.1:8765 p3at1
//
// It attaches itself (the service attach_controller), gets readings on the stream sim/ports/wander, and
// answers each of them by set_ports. It runs in lockstep: the simulation waits for each answer.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "robotcontrol/World.pb.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"

using nlohmann::json;
using robotlink::websocket::Client;

namespace {

constexpr double kNear = 0.8, kSpeed = 0.4;  // m, m/s

class Wanderer {
 public:
  explicit Wanderer(std::string robot) : robot_(std::move(robot)) {}

  json attachment() const {
    return {{"name", "wander"},
            {"sensors", {robot_ + "/laser"}},
            {"outputs", {{{"path", "nearest"}, {"type", "distance"}, {"unit", "m"}, {"maximum", 10}}}},
            {"lockstep", true},
            {"patience", 1},
            {"every", 5}};
  }

  /// What to do about the readings: drive on, or turn to where there is more room.
  json answer(const robotcontrol::ControllerInputs& inputs) const {
    json answer{{"controller", "wander"}, {"step", inputs.step()}};
    if (inputs.readings().empty() || inputs.readings(0).values().empty()) return answer;
    const auto& ranges = inputs.readings(0).values();
    const auto middle = ranges.begin() + ranges.size() / 2;
    const double right = *std::min_element(ranges.begin(), middle + 1);
    const double left = *std::min_element(middle, ranges.end());
    const double turn = std::min(left, right) > kNear ? 0 : left > right ? 0.2 : -0.2;
    const double speed = turn == 0 ? kSpeed : 0;
    answer["commands"] = {{{"port", robot_ + "/drive"}, {"values", {speed - turn, speed + turn}}}};
    answer["outputs"] = {{{"port", "nearest"}, {"values", {std::min(left, right)}}}};
    return answer;
  }

 private:
  const std::string robot_;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "Usage: wander SERVER ROBOT, such as: wander ws://127.0.0.1:8765 p3at1\n";
    return 2;
  }
  const auto url = robotlink::websocket::parseServerUrl(arguments[1]);
  if (!url) {
    std::cerr << url.error().text << "\n";
    return 2;
  }
  const Wanderer wanderer(arguments[2]);
  std::shared_ptr<Client> client;
  const auto call = [&client](const std::string& service, const json& what) {
    client->call({service, "json", what.dump()}, [service](robotlink::Result<Client::Answer> answer) {
      if (!answer) std::cerr << service << ": " << answer.error().text << "\n";
      const json result = answer ? json::parse(answer->data, nullptr, false) : json();
      if (result.is_object() && !result.value("accepted", true))
        std::cerr << service << ": " << result.value("reason", "refused") << "\n";
    });
  };
  robotlink::websocket::ClientHandlers handlers;
  // Services are there again after each connection.
  handlers.servicesAdded = [&](const auto& services) {
    for (const auto& service : services)
      if (service.name == "attach_controller") call("attach_controller", wanderer.attachment());
  };
  handlers.message = [&](const auto&, robotlink::Instant, std::string_view payload) {
    robotcontrol::ControllerInputs inputs;
    if (inputs.ParseFromString(std::string(payload))) call("set_ports", wanderer.answer(inputs));
  };
  client = std::make_shared<Client>(handlers);
  client->subscribe({"sim/ports/wander"});
  robotlink::websocket::Connector::Options options;
  options.url = *url;
  options.name = "wander";
  const robotlink::websocket::Connector connector(client, options);
  while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
}
