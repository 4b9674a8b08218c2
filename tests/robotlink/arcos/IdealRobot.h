// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/server/ServerSession.h"
#include "tests/robotlink/arcos/IdealWheels.h"

/// A microcontroller on ideal wheels in an empty world, together with its client: without sockets and without
/// waiting.
class IdealRobot : public robotlink::arcos::RangeFinders {
 public:
  explicit IdealRobot(robotlink::arcos::ServerSettings settings = {}) : session(std::move(settings)) {}

  robotlink::arcos::ServerSession session;
  robotlink::arcos::RobotSensing sensing;
  /// Packets received by the client.
  std::vector<robotlink::arcos::Packet> received;
  std::vector<robotlink::Instant> receivedAt;
  /// Number of times that each sonar has fired.
  std::map<int, int> shots;
  int scans = 0;
  std::vector<double> scan = std::vector<double>(181, 7.0);
  robotlink::Instant now;

  void send(const robotlink::arcos::Packet& packet) {
    session.take(packet, now);
    collect();
  }
  void send(robotlink::arcos::CommandId id) { send(toPacket(robotlink::arcos::command(id))); }
  void send(robotlink::arcos::CommandId id, int argument) {
    send(toPacket(robotlink::arcos::command(id, argument)));
  }
  void send(robotlink::arcos::CommandId id, std::string argument) {
    send(toPacket(robotlink::arcos::command(id, std::move(argument))));
  }

  void connect() {
    using robotlink::arcos::CommandId;
    for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2}) send(id);
    send(CommandId::kOpen, 1);
  }

  void step() {
    now += IdealWheels::kStep;
    wheels.obey(session.step(sensing, *this, now));
    sensing.leftTravel = wheels.wheels.leftTravel;
    sensing.rightTravel = wheels.wheels.rightTravel;
    sensing.leftSpeed = wheels.command.left;
    sensing.rightSpeed = wheels.command.right;
    collect();
  }
  /// Runs while the client sends nothing.
  void run(double time) {
    for (const auto end = now + robotlink::fromSeconds(time); now < end;) step();
  }
  /// Runs while the client sends a pulse each half second.
  void drive(double time) {
    for (const auto end = now + robotlink::fromSeconds(time); now < end;) {
      send(robotlink::arcos::CommandId::kPulse);
      run(std::min(0.5, robotlink::seconds(end - now)));
    }
  }

  std::vector<robotlink::arcos::Packet> of(std::uint8_t id) const {
    std::vector<robotlink::arcos::Packet> found;
    for (const auto& packet : received) {
      if (packet.id == id) found.push_back(packet);
    }
    return found;
  }
  std::vector<robotlink::arcos::StandardInformation> information() const {
    std::vector<robotlink::arcos::StandardInformation> found;
    for (const auto& packet : received) {
      if ((packet.id & 0xF0) == 0x30) found.push_back(*robotlink::arcos::decode<robotlink::arcos::StandardInformation>(packet));
    }
    return found;
  }
  void forget() {
    received.clear();
    receivedAt.clear();
  }

  double sonar(int number) override {
    ++shots[number];
    return 1 + 0.1 * number;
  }
  std::span<const double> laser() override {
    ++scans;
    return scan;
  }

  IdealWheels wheels;

 private:
  void collect() {
    for (auto& packet : session.takeOutgoing()) {
      received.push_back(std::move(packet));
      receivedAt.push_back(now);
    }
  }
};
