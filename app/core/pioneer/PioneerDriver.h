// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/pioneer/LinkMeter.h"
#include "app/core/pioneer/PioneerPackages.h"
#include "robotlink/arcos/ClientSession.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/process/Process.h"
#include "robotlink/process/Receiver.h"
#include "robotlink/process/Sender.h"

namespace robotcontrol {
class ControlDrive;
}

namespace app {

/// The driver of a Pioneer: the part of a platform that speaks ARCOS with it, whether it is real or
/// simulated. Sends drive/state, range/sonar, range/laser, link/status and, on request, link/packets; drives
/// as drive/request wants.
///
/// A program that says nothing for kSilence is told of as stopped, and the robot stands: it never goes on
/// with what a program that hangs wanted last. While STOP is engaged the motors are off. Whether they are
/// switched on when the robot is connected is for the owner to say: a real robot waits for a person.
///
/// The owner moves the packets; now and then are those of the platform's clock. One thread.
class PioneerDriver {
 public:
  static constexpr robotlink::Duration kSilence = std::chrono::seconds(1);

  struct Options {
    std::string address;    ///< for people
    bool motorsOn = false;  ///< as soon as it is connected
    /// Ask a simulator for its laser. That of a real robot has a line of its own, which nobody reads here.
    bool laser = true;
  };

  /// Both must outlive it.
  PioneerDriver(robotlink::Process& platform, std::string robot,
                const robotlink::RobotDescription& description, Options options);

  // The line: its owner opens it when wanted, and says how that went.
  bool wantsLine() const { return session_.wantsLink(); }
  /// It cannot go on before lineOpened().
  bool waitsForLine() const {
    return session_.state() == robotlink::arcos::ClientSession::State::kWaitingForLink;
  }
  void lineOpened(robotlink::Instant now);
  void lineLost(const robotlink::Error& why, robotlink::Instant now);
  void take(std::span<const std::uint8_t> bytes, robotlink::Instant now);
  void take(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  /// Of a connection between the robot and somebody else, who drives it meanwhile: this driver only listens.
  void overhear(const robotlink::arcos::Packet& packet, bool fromRobot, robotlink::Instant now);
  /// Who that is; empty: nobody, and this driver connects again.
  void setOtherClient(const std::string& address, robotlink::Instant now);

  /// Does what program, persons and time want. What goes to the robot is in takeOutgoing() then.
  void actuate(bool stopEngaged, robotlink::Instant now);
  std::vector<robotlink::arcos::Packet> takeOutgoing(robotlink::Instant now);
  /// Sends the packages of what came.
  void sendPackages(robotlink::Instant now);
  /// What a person is to be told of setting the robot up, since the last call; empty: nothing.
  std::string takeReport() { return std::exchange(report_, {}); }
  /// Tries again at once where it waits before it does.
  void connectNow(robotlink::Instant now) { session_.connectNow(now); }
  /// Ends the connection in good order: motors off, CLOSE.
  void end(robotlink::Instant now) { session_.close(now); }

  robotlink::Result<void> control(const robotcontrol::ControlDrive& details, robotlink::Instant now);
  /// A layout may need some of them or none: Platform::onRequest().
  std::vector<robotlink::AnySender*> senders();
  const robotlink::arcos::ClientSession& session() const { return session_; }

 private:
  void use(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  void followConnection(robotlink::Instant now);
  void becomeConnected(robotlink::Instant now);
  void startLaser(robotlink::Instant now);
  void drive(robotlink::Instant now);
  void command(robotlink::arcos::CommandId id, int argument, robotlink::Instant now);
  void sendStatus(robotlink::Instant now);

  const Options options_;
  const robotlink::RobotDescription& description_;
  PioneerPackages packages_;
  robotlink::arcos::ClientSession session_;
  robotlink::arcos::PacketParser parser_, outgoingParser_;
  LinkMeter meter_;
  bool motorsWanted_;
  std::string otherClient_;
  std::string report_;
  robotlink::Instant lineOpened_, lastBytes_, requestCame_, commandSent_, statusSent_;
  int speedMmS_ = 0, rotationDegS_ = 0;  // as commanded last
  bool connected_ = false, held_ = false, driving_ = false;

  std::shared_ptr<const robotcontrol::DriveState> state_;  // new ones, until they are sent
  std::shared_ptr<const robotcontrol::SonarReadings> sonars_;
  std::shared_ptr<const foxglove::LaserScan> laser_;
  robotlink::Sender<robotcontrol::DriveState> stateSender_;
  robotlink::Sender<robotcontrol::SonarReadings> sonarSender_;
  robotlink::Sender<foxglove::LaserScan> laserSender_;
  robotlink::Sender<robotcontrol::LinkStatus> statusSender_;
  robotlink::Sender<robotcontrol::LinkPackets> packetsSender_;
  robotlink::Receiver<robotcontrol::DriveRequest> request_;
};

}  // namespace app
