// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/platforms/pioneer/LinkMeter.h"
#include "app/platforms/pioneer/PioneerPackages.h"
#include "robotcontrol/Accessories.pb.h"
#include "robotlink/arcos/PioneerClient.h"
#include "robotlink/process/Process.h"
#include "robotlink/process/Receiver.h"
#include "robotlink/process/Sender.h"

namespace robotcontrol {
class ControlDrive;
}

namespace app {

/// The driver of a Pioneer: the part of a platform that speaks ARCOS with the robot, real or simulated. It
/// sends the packages drive/state, range/sonar, range/laser, link/status, of robots with a gripper
/// body/gripper and, on request, link/packets, and drives as the package drive/request asks.
///
/// If the program sends no request for kSilence, the robot stops, so that it never continues with the last
/// request of a program that hangs. While STOP is engaged, the motors are off. The owner decides whether the
/// motors are switched on at each connection: those of a real robot wait for the user.
///
/// The owner moves the packets between this object and the line. All times are those of the platform's clock.
/// One thread.
class PioneerDriver final : private robotlink::arcos::PioneerClient::Listener {
 public:
  /// The time for which a drive request is valid.
  static constexpr robotlink::Duration kSilence = std::chrono::seconds(1);

  /// Fixed settings of a driver.
  struct Options {
    /// The robot's address for users.
    std::string address;
    /// Whether the motors are switched on when the robot is connected.
    bool motorsOn = false;
    /// Whether a simulator has to send laser scans. The laser of a real robot has a line of its own, whose
    /// scans arrive by takeScan().
    bool laser = true;
  };

  /// Requests a connection at once. Platform and description must outlive this object.
  PioneerDriver(robotlink::Process& platform, std::string robot,
                const robotlink::RobotDescription& description, Options options);

  /// Whether the line should be open.
  bool wantsLine() const { return client_.wantsLink(); }
  /// Whether the connection can continue only after lineOpened().
  bool waitsForLine() const {
    return session().state() == robotlink::arcos::ClientSession::State::kWaitingForLink;
  }
  /// The owner has opened the line.
  void lineOpened(robotlink::Instant now);
  /// The line could not be opened, or broke.
  void lineLost(const robotlink::Error& why, robotlink::Instant now);
  /// Processes bytes from the line.
  void take(std::span<const std::uint8_t> bytes, robotlink::Instant now);
  /// Processes a packet from a robot that is reached without a line.
  void take(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  /// Takes a scan of a laser at a line of its own, in the laser's frame.
  void takeScan(const robotlink::arcos::RangeScan& scan);
  /// Sets what that laser does, a sentence without its period that link/status gets.
  void setLaserText(std::string text) { laserText_ = std::move(text); }
  /// Processes a packet between the robot and another client, which drives the robot meanwhile. Nothing is
  /// sent.
  void overhear(const robotlink::arcos::Packet& packet, bool fromRobot, robotlink::Instant now);
  /// Sets the address of another client that drives the robot. This driver then closes its connection and
  /// only listens; when the address is empty again, it reconnects.
  void setOtherClient(const std::string& address, robotlink::Instant now);

  /// Sends commands as the program, STOP and time require; call this every cycle. The packets are then in
  /// takeOutgoing().
  void actuate(bool stopEngaged, robotlink::Instant now);
  /// Removes and returns the packets for the robot.
  std::vector<robotlink::arcos::Packet> takeOutgoing(robotlink::Instant now) {
    return client_.takeOutgoing(now);
  }
  /// Removes and returns these packets as a line needs them: the bytes of a packet each.
  std::vector<robotlink::arcos::Bytes> takeOutgoingFrames(robotlink::Instant now) {
    return client_.takeOutgoingFrames(now);
  }
  /// Sends packages with what was received since the last call.
  void sendPackages(robotlink::Instant now);
  /// Removes and returns a sentence for the user about the last connection; empty if there is nothing new.
  std::string takeReport() { return std::exchange(report_, {}); }
  /// Ends the pause between two attempts to connect.
  void connectNow(robotlink::Instant now) { client_.connectNow(now); }
  /// Ends the connection properly: motors off, then CLOSE.
  void end(robotlink::Instant now) { client_.close(now); }

  /// Fulfills a request of the user for the base: motors, sonars, odometry, packets. Fails if the robot is
  /// not connected, if STOP forbids the motors, or if bytes that are to be sent are no packets.
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details, robotlink::Instant now);
  /// All senders. A layout may need some of them or none; see Platform::onRequest().
  std::vector<robotlink::AnySender*> senders();
  const robotlink::arcos::ClientSession& session() const { return client_.session(); }

 private:
  // Reports of the client.
  void packetPassed(robotlink::arcos::Direction direction, const robotlink::arcos::Packet& packet,
                    std::span<const std::uint8_t> frame, robotlink::Instant now) override;
  void damageCame(const robotlink::arcos::DamagedBytes& damage, robotlink::Instant now) override;
  void robotIdentified() override { packages_.restart(); }
  void configurationCame(const robotlink::arcos::Configuration& configuration) override;
  void stateCame(const robotlink::arcos::StandardInformation& information, robotlink::Instant now) override;
  void scanCame(const robotlink::arcos::RangeScan& scan) override;
  void connectionChanged(bool connected, robotlink::Instant now) override;
  /// Sets the robot up after connecting: sonars, laser, motors.
  void setUp(robotlink::Instant now);
  /// Sends speeds if they have changed or are to be repeated, and a stop command once when the request
  /// expires.
  void drive(robotlink::Instant now);
  /// Sends a command if the robot is connected, otherwise nothing.
  void command(robotlink::arcos::CommandId id, int argument, robotlink::Instant now);
  /// Sends link/status.
  void sendStatus(robotlink::Instant now);

  const Options options_;
  const robotlink::RobotDescription& description_;
  PioneerPackages packages_;
  robotlink::arcos::PioneerClient client_{*this};
  LinkMeter meter_;
  /// Whether the user wants the motors on, apart from STOP.
  bool motorsWanted_;
  /// Empty if no other client drives the robot.
  std::string otherClient_;
  /// Empty if there is no laser at a line of its own.
  std::string laserText_;
  /// For takeReport().
  std::string report_;
  /// The times of the last event of each kind.
  robotlink::Instant lineOpened_, lastBytes_, commandSent_, statusSent_;
  /// The time of the program's newest request; unset if the robot was held since.
  std::optional<robotlink::Instant> requestCame_;
  /// The speeds that were last commanded, mm/s and degrees/s; valid while driving_.
  int speedMmS_ = 0, rotationDegS_ = 0;
  /// The state in the last actuate(): whether STOP is engaged, and whether the last command made it drive.
  bool held_ = false, driving_ = false;

  /// Received data that was not sent yet; null if there is none.
  std::shared_ptr<const robotcontrol::DriveState> state_;
  std::shared_ptr<const robotcontrol::SonarReadings> sonars_;
  std::shared_ptr<const foxglove::LaserScan> laser_;
  std::shared_ptr<const robotcontrol::GripperState> gripper_;
  /// Whether the robot says in its configuration that it has a gripper; unset: it has not sent it yet.
  std::optional<bool> hasGripper_;
  robotlink::Sender<robotcontrol::DriveState> stateSender_;
  robotlink::Sender<robotcontrol::SonarReadings> sonarSender_;
  robotlink::Sender<foxglove::LaserScan> laserSender_;
  robotlink::Sender<robotcontrol::GripperState> gripperSender_;
  robotlink::Sender<robotcontrol::LinkStatus> statusSender_;
  robotlink::Sender<robotcontrol::LinkPackets> packetsSender_;
  robotlink::Receiver<robotcontrol::DriveRequest> request_;
};

}  // namespace app
