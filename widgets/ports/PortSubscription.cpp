// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ports/PortSubscription.h"

#include <algorithm>
#include <map>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/Requests.h"

namespace widgets {
namespace {

constexpr std::string_view kPortSelector = "port=\"";

const robotcontrol::WorldPort* portAt(const robotcontrol::WorldObjects& objects, const std::string& path) {
  const auto found = std::ranges::find_if(objects.objects(), [&](const robotcontrol::WorldObject& object) {
    return object.has_port() && object.port().path() == path;
  });
  return found == objects.objects().end() ? nullptr : &found->port();
}

}  // namespace

void PortSubscription::want(robotlink::Session& session, const std::vector<std::string>& ports) {
  if (ports.empty()) return;
  if (const auto generation = session.store().generation(); generation != generation_) {
    generation_ = generation;
    asked_.clear();
    unknown_.clear();
    objects_.reset();
  }
  const auto isNew = [this](const std::string& port) {
    return !asked_.contains(port) && !unknown_.contains(port);
  };
  const auto* message = session.store().latest(robotlink::streams::kObjects, session.timeline().newest());
  if (message != nullptr && message->value != objects_) {
    objects_ = message->value;
    unknown_.clear();
  }
  if (std::ranges::none_of(ports, isNew)) return;
  const auto* objects = dynamic_cast<const robotcontrol::WorldObjects*>(objects_.get());
  if (objects == nullptr) return;
  std::map<std::string, robotcontrol::Request> requests;  // by robot
  for (const std::string& port : ports) {
    if (!isNew(port)) continue;
    const robotcontrol::WorldPort* known = portAt(*objects, port);
    (known == nullptr ? unknown_ : asked_).insert(port);
    if (known == nullptr) continue;
    const auto& robots = session.robots();
    const bool isRobot = std::ranges::find(robots, known->robot()) != robots.end();
    requests[isRobot ? known->robot() : std::string()].mutable_read_ports()->add_ports(port);
  }
  // Failures are ignored: without a simulation, such as in a log, there are no ports to read.
  for (auto& [robot, request] : requests)
    ask(session, robot, std::move(request), nullptr, [](bool, const QString&) {});
}

std::vector<std::string> portsNamedIn(std::string_view text) {
  std::vector<std::string> ports;
  for (std::size_t at = text.find(kPortSelector); at != std::string_view::npos;
       at = text.find(kPortSelector, at)) {
    at += kPortSelector.size();
    const std::size_t end = text.find('"', at);
    if (end == std::string_view::npos) break;
    ports.emplace_back(text.substr(at, end - at));
  }
  return ports;
}

std::string portField(const std::string& port, int value) {
  return "readings[" + std::string(kPortSelector) + port + "\"].values[" + std::to_string(value) + "]";
}

}  // namespace widgets
