// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerPlatform.h"

namespace app {
namespace {

/// Combines lambdas to one visitor for std::visit().
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

PioneerPlatform::PioneerPlatform(const robotlink::Clock& clock, std::string robot,
                                 const robotlink::RobotDescription& description,
                                 PioneerDriver::Options options, const PioneerAddress& address)
    : RealPlatform("platform", clock),
      driver_(*this, std::move(robot), description, options),
      line_(options.address, clock) {
  if (address.laser) laser_ = std::make_unique<PioneerLaser>(*address.laser, address.scans, clock);
}

PioneerPlatform::~PioneerPlatform() {
  PioneerPlatform::shutDown();
}

void PioneerPlatform::shutDown() {
  if (std::exchange(shutDown_, true)) return;
  driver_.end(clock().now());
  sendWaiting();
}

void PioneerPlatform::takeEvents() {
  for (const PioneerLine::Event& event : line_.take()) {
    std::visit(Overloaded{[&](const PioneerLine::Opened&) { driver_.lineOpened(event.time); },
                          [&](const PioneerLine::Bytes& bytes) { driver_.take(bytes, event.time); },
                          [&](const PioneerLine::Lost& lost) { driver_.lineLost(lost.why, event.time); }},
               event.what);
  }
}

void PioneerPlatform::stepLaser() {
  if (!laser_) return;
  laser_->step();
  while (const auto scan = laser_->takeScan()) driver_.takeScan(*scan);
  driver_.setLaserText(laser_->session().describe());
}

void PioneerPlatform::sendWaiting() {
  for (auto& frame : driver_.takeOutgoingFrames(clock().now())) line_.send(std::move(frame));
}

void PioneerPlatform::engageStop(bool engaged) {
  stopEngaged_.store(engaged);
  if (!engaged) return;  // The motors are switched on again by actuate(), if they were.
  stopSent_.store(true);
  using robotlink::arcos::CommandId;
  for (const auto& command :
       {robotlink::arcos::command(CommandId::kEStop), robotlink::arcos::command(CommandId::kEnable, 0)})
    line_.sendUrgent(robotlink::arcos::encode(toPacket(command)));
}

void PioneerPlatform::actuate() {
  takeEvents();
  // STOP may have been engaged and released again since the last step: its commands were sent all the same.
  if (stopSent_.exchange(false)) driver_.actuate(true, clock().now());
  driver_.actuate(mustStand(), clock().now());
  sendWaiting();
  stepLaser();
  if (const std::string text = driver_.takeReport(); !text.empty()) report(text);
  if (driver_.wantsLine()) {
    line_.open();
  } else {
    line_.close();
  }
}

std::vector<RealPlatform::Figure> PioneerPlatform::connectionFigures() const {
  const auto& statistics = driver_.session().statistics();
  const std::uint64_t scans = laser_ ? laser_->session().counters().scans : statistics.scans;
  return {{"packets", statistics.packets},
          {"standard_informations", statistics.information},
          {"undecodable_packets", statistics.undecodable},
          {"scans", scans},
          {"connections", statistics.connections},
          {"losses", statistics.losses},
          {"round_trip_s", robotlink::seconds(statistics.roundTrip)},
          {"longest_gap_s", robotlink::seconds(statistics.longestGap)}};
}

void PioneerPlatform::execute() {
  driver_.sendPackages(clock().now());
}

}  // namespace app
