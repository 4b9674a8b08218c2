// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "robotlink/arcos/server/ServerSession.h"
#include "tests/robotlink/arcos/IdealWheels.h"
#include "tests/robotlink/arcos/PacketClient.h"

/// A microcontroller on ideal wheels in an empty world, together with its client: without sockets and without
/// waiting.
class IdealRobot : public robotlink::arcos::RangeFinders, public robotlink::arcos::PacketClient {
 public:
  explicit IdealRobot(robotlink::arcos::ServerSettings settings = {}) : session(std::move(settings)) {}

  robotlink::arcos::ServerSession session;
  robotlink::arcos::RobotSensing sensing;
  /// Number of times that each sonar has fired.
  std::map<int, int> shots;
  int scans = 0;
  std::vector<double> scan = std::vector<double>(181, 7.0);
  robotlink::Instant now;

  using PacketClient::send;
  void send(const robotlink::arcos::Packet& packet) override {
    session.take(packet, now);
    collect();
  }
  void connect() { handshake(); }

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
    for (auto& packet : session.takeOutgoing()) store(std::move(packet), now);
  }
};
