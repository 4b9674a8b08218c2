// SPDX-License-Identifier: GPL-3.0-or-later
// A controller of a simulation as a program of its own: lets a robot on wheels wander without hitting
// anything.
//
//     robotctl sim pioneer --listen 8765 &
//     wander ws://127.0.0.1:8765 p3at1
//
// It attaches itself (the service attach_controller), gets readings on the stream sim/ports/wander, and
// answers each of them by set_ports. In lockstep (the default) the simulation waits for each answer; with
// --free it does not. --start starts the simulation, as one of robotctl sim --listen --paused; --steps 100
// ends it after so many answers.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <future>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "robotcontrol/World.pb.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"

using nlohmann::json;
using robotlink::websocket::Client;

namespace {

constexpr double kNear = 0.8, kSpeed = 0.4;  // m, m/s

struct Options {
  std::string server, robot;
  /// Whether the simulation does not wait for answers, and whether it is started.
  bool free = false, start = false;
  /// After so many answers it ends; 0: never.
  int steps = 0;
};

/// Unset if the words are wrong.
std::optional<Options> optionsIn(const std::vector<std::string_view>& words) {
  Options options;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--free") {
      options.free = true;
    } else if (words[i] == "--start") {
      options.start = true;
    } else if (words[i] == "--steps" && i + 1 < words.size()) {
      options.steps = std::atoi(std::string(words[++i]).c_str());
    } else if (words[i].starts_with("-")) {
      return std::nullopt;
    } else {
      names.emplace_back(words[i]);
    }
  }
  if (names.size() != 2) return std::nullopt;
  options.server = names[0];
  options.robot = names[1];
  return options;
}

class Wanderer {
 public:
  explicit Wanderer(const Options& options) : robot_(options.robot), isFree_(options.free) {}

  json attachment() const {
    return {{"name", "wander"},
            {"sensors", {robot_ + "/laser"}},
            {"outputs", {{{"path", "nearest"}, {"type", "distance"}, {"unit", "m"}, {"maximum", 10}}}},
            {"lockstep", !isFree_},
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
  const bool isFree_;
};

}  // namespace

int main(int count, char** arguments) {
  auto options = optionsIn({arguments + 1, arguments + count});
  if (!options) {
    std::cerr << "Usage: wander SERVER ROBOT [--free] [--start] [--steps NUMBER], such as: wander "
                 "ws://127.0.0.1:8765 p3at1\n";
    return 2;
  }
  const auto url = robotlink::websocket::parseServerUrl(options->server);
  if (!url) {
    std::cerr << url.error().text << "\n";
    return 2;
  }
  const Wanderer wanderer(*options);
  std::shared_ptr<Client> client;
  /// Calls a service; `then` is called when it was accepted.
  const auto call = [&client](const std::string& service, const json& what, std::function<void()> then = {}) {
    client->call({service, "json", what.dump()}, [service, then](robotlink::Result<Client::Answer> answer) {
      if (!answer) std::cerr << service << ": " << answer.error().text << "\n";
      const json result = answer ? json::parse(answer->data, nullptr, false) : json();
      const bool isAccepted = result.is_object() && result.value("accepted", true);
      if (isAccepted && then) then();
      if (result.is_object() && !isAccepted)
        std::cerr << service << ": " << result.value("reason", "refused") << "\n";
    });
  };
  robotlink::websocket::ClientHandlers handlers;
  // Services are there again after each connection, but the simulation is started once.
  handlers.servicesAdded = [&](const auto& services) {
    for (const auto& service : services) {
      if (service.name != "attach_controller") continue;
      call("attach_controller", wanderer.attachment(), [&] {
        if (std::exchange(options->start, false)) call("control_simulation", {{"action", "START"}});
      });
    }
  };
  std::promise<void> ended;
  int answers = 0;
  handlers.message = [&](const auto&, robotlink::Instant, std::string_view payload) {
    robotcontrol::ControllerInputs inputs;
    if (!inputs.ParseFromString(std::string(payload))) return;
    call("set_ports", wanderer.answer(inputs));
    if (++answers == options->steps)
      call("attach_controller", {{"name", "wander"}, {"ended", true}}, [&] { ended.set_value(); });
  };
  client = std::make_shared<Client>(handlers);
  client->subscribe({"sim/ports/wander"});
  robotlink::websocket::Connector::Options to;
  to.url = *url;
  to.name = "wander";
  const robotlink::websocket::Connector connector(client, to);
  ended.get_future().wait();
}
