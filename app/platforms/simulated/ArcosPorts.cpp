// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/ArcosPorts.h"

#include <filesystem>

#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "robotlink/base/Printable.h"
#include "simcore/Scene.h"

namespace app {
namespace {

namespace request = robotlink::arcos::simulator_request;
using Clock = std::chrono::steady_clock;

}  // namespace

robotlink::Result<std::unique_ptr<ArcosPorts>> ArcosPorts::open(SimulatedWorld& world, const Options& options,
                                                                Log logger) {
  if (world.pioneers().empty()) {
    return robotlink::failure("arcos.no-robot",
                              "there is no Pioneer in this world to connect to; add some with --robots");
  }
  std::unique_ptr<ArcosPorts> made(new ArcosPorts(world, options, std::move(logger)));
  auto ports =
      robotlink::arcos::RobotPorts::open({options.address, options.firstPort, world.pioneers().size()});
  if (!ports) return tl::unexpected(ports.error());
  made->ports_ = std::move(*ports);
  return made;
}

ArcosPorts::ArcosPorts(SimulatedWorld& world, Options options, Log logger)
    : world_(world), options_(std::move(options)), log_(std::move(logger)), texts_(world.pioneers().size()) {}

ArcosPorts::~ArcosPorts() {
  for (const auto& pioneer : world_.pioneers()) {
    if (pioneer->outsideClient().empty()) continue;
    pioneer->clientGone(world_.clock().now());
    pioneer->setOutsideClient({});
  }
}

void ArcosPorts::log(std::size_t robot, const std::string& text) {
  if (!texts_[robot].admit(Clock::now())) return;
  if (log_) log_(world_.pioneers()[robot]->robot() + ": " + text);
}

void ArcosPorts::logSuppressed() {
  const auto now = Clock::now();
  for (std::size_t robot = 0; robot < texts_.size(); ++robot) {
    const std::uint64_t count = texts_[robot].takeSuppressed(now);
    if (count == 0 || !log_) continue;
    log_(world_.pioneers()[robot]->robot() + ": " + std::to_string(count) +
         " more messages from its client are not shown: there are too many");
  }
}

std::string ArcosPorts::url(std::size_t robot) const {
  const bool six = options_.address.find(':') != std::string::npos;
  return "tcp://" + (six ? "[" + options_.address + "]" : options_.address) + ":" +
         std::to_string(ports_->port(robot));
}

std::string ArcosPorts::warning() const {
  if (ports_->loopbackOnly()) return {};
  return "the robots can be driven from every machine that reaches " + options_.address +
         ", because ARCOS has no password; to prevent this, open the ports to this machine only";
}

void ArcosPorts::clientCame(std::size_t robot, const std::string& address) {
  SimulatedPioneer& pioneer = *world_.pioneers()[robot];
  // This disconnects the program that runs here, if there is one.
  pioneer.clientGone(world_.clock().now());
  pioneer.setOutsideClient(address);
  log(robot, "connected from " + address);
}

void ArcosPorts::packetCame(std::size_t robot, const robotlink::arcos::Packet& packet) {
  world_.pioneers()[robot]->take(packet, world_.clock().now());
}

void ArcosPorts::clientGone(std::size_t robot) {
  SimulatedPioneer& pioneer = *world_.pioneers()[robot];
  log(robot, pioneer.outsideClient() + " is gone");
  pioneer.clientGone(world_.clock().now());
  pioneer.setOutsideClient({});
}

void ArcosPorts::serve(std::chrono::steady_clock::time_point until) {
  ports_->serve(*this, until);
}

void ArcosPorts::deliver() {
  logSuppressed();
  const auto pioneers = world_.pioneers();
  for (std::size_t robot = 0; robot < pioneers.size(); ++robot) {
    fulfilRequests(robot);
    if (pioneers[robot]->outsideClient().empty()) continue;
    if (const auto packets = pioneers[robot]->takeOutgoing(); !packets.empty()) ports_->send(robot, packets);
  }
}

void ArcosPorts::fulfilRequests(std::size_t robot) {
  for (const auto& details : world_.pioneers()[robot]->takeRequests()) {
    if (const auto* message = std::get_if<request::Message>(&details)) {
      log(robot, robotlink::printable(message->text));
    } else if (const auto* exit = std::get_if<request::Exit>(&details)) {
      log(robot, "its client asks the simulation to end");
      exit_ = exit->status;
    } else if (const auto* map = std::get_if<request::LoadMap>(&details)) {
      // The map of a running world does not change; a client that asks for the same one has what it wants.
      const std::filesystem::path present = world_.simulation().scene().file();
      const bool same = std::filesystem::path(map->file).filename() == present.filename();
      if (!same)
        log(robot, "its client asks for the map " + robotlink::printable(map->file) + "; " +
                       present.string() + " stays");
      world_.pioneers()[robot]->mapLoaded(present.string(), same, false);
    }
  }
}

}  // namespace app
