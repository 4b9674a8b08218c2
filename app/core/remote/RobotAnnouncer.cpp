// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/RobotAnnouncer.h"

#include <algorithm>
#include <filesystem>

#include "robotcontrol/Logging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotlink::dds::AnnouncedRobot;

/// "ers210" of "ers210.yaml".
std::string stemOf(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

}  // namespace

std::vector<AnnouncedRobot> robotsToAnnounce(robotlink::Session& session) {
  std::vector<AnnouncedRobot> robots;
  for (const std::string& name : session.robots()) {
    AnnouncedRobot& robot = robots.emplace_back();
    robot.name = name;
    const auto* setup = session.store().latestAs<robotcontrol::ProgramSetup>(
        name + "/" + robotlink::streams::kProgram, robotlink::Instant::max());
    if (setup == nullptr) continue;
    robot.kind = stemOf(setup->description().name());
    robot.layout = stemOf(setup->layout().name());
    robot.isBody = setup->is_body();
  }
  return robots;
}

RobotAnnouncer::RobotAnnouncer(const robotlink::websocket::ListenAddress& address, const ListenAccess& access,
                               Nodes nodes)
    : address_(address.address), nodes_(std::move(nodes)) {
  if (isLoopback(address)) return;
  const auto& certificate = access.listening.certificate;
  what_.port = address.port;
  what_.isEncrypted = certificate.has_value();
  what_.fingerprint = certificate ? certificate->fingerprint : std::string();
  worker_ = std::make_unique<robotlink::Worker<Robots>>(
      [this](const Robots& robots, const std::stop_token&) { announce(robots); },
      robotlink::Worker<Robots>::Options{.end = [this] { announcement_.reset(); }});
}

void RobotAnnouncer::update(Robots robots) {
  if (!worker_ || robots.empty() || robots == announced_) return;
  announced_ = robots;
  worker_->post(std::move(robots));
}

void RobotAnnouncer::announce(const Robots& robots) {
  if (announcement_) return announcement_->update(robots);
  what_.robots = robots;
  auto nodes = nodes_(address_);
  if (nodes.empty()) return;
  if (auto opened = robotlink::dds::RobotAnnouncement::open(std::move(nodes), what_))
    announcement_ = std::move(*opened);
}

}  // namespace app
