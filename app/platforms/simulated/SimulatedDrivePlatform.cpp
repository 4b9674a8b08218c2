// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedDrivePlatform.h"

#include "app/platforms/simulated/world/SimulatedPioneer.h"

namespace app {

robotlink::Result<std::unique_ptr<SimulatedPlatform>> SimulatedDrivePlatform::create(
    SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description) {
  SimulatedPioneer* pioneer = world.pioneer(robot);
  if (pioneer == nullptr) {
    return robotlink::failure("platform.drive",
                              "robot " + robot + " has no drive, which its description " + description.name +
                                  " names; correct the model or resources/robots/" + description.name +
                                  ".yaml",
                              {}, {robot});
  }
  return std::unique_ptr<SimulatedPlatform>(
      new SimulatedDrivePlatform(world, *pioneer, std::move(robot), description));
}

SimulatedDrivePlatform::SimulatedDrivePlatform(SimulatedWorld& world, SimulatedPioneer& pioneer,
                                               std::string robot,
                                               const robotlink::RobotDescription& description)
    : SimulatedPlatform(world, robot),
      pioneer_(pioneer),
      driver_(*this, std::move(robot), description, {.address = "simulated", .motorsOn = true}) {}

void SimulatedDrivePlatform::initialize() {
  listens_ = true;
  if (pioneer_.outsideClient().empty()) pioneer_.clientGone(clock().now());
  pioneer_.setListener([this](const auto& packet, bool fromRobot, robotlink::Instant now) {
    driver_.overhear(packet, fromRobot, now);
  });
}

void SimulatedDrivePlatform::shutDown() {
  if (std::exchange(listens_, false)) pioneer_.setListener({});
}

void SimulatedDrivePlatform::actuate() {
  const robotlink::Instant now = clock().now();
  pioneer_.setStopButton(stopEngaged());
  driver_.setOtherClient(pioneer_.outsideClient(), now);
  if (driver_.waitsForLine()) driver_.lineOpened(now);
  driver_.actuate(mustStand(), now);
  const auto packets = driver_.takeOutgoing(now);
  if (!pioneer_.outsideClient().empty()) return;
  for (const auto& packet : packets) pioneer_.take(packet, now);
  if (const std::string text = driver_.takeReport(); !text.empty()) report(text);
}

void SimulatedDrivePlatform::execute() {
  const robotlink::Instant now = clock().now();
  if (pioneer_.outsideClient().empty()) {
    for (const auto& packet : pioneer_.takeOutgoing()) driver_.take(packet, now);
  }
  driver_.sendPackages(now);
  sendOracle();
  exchangeGame();
}

robotlink::Result<void> SimulatedDrivePlatform::control(const robotcontrol::ControlDrive& details) {
  return driver_.control(details, clock().now());
}

}  // namespace app
