// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/arcos/server/ServerSettings.h"

namespace robotlink::arcos {

/// The laser of robots of the MobileSim family, whose scans go over the robot's own line: the settings that a
/// client made by the commands 230 to 233 (or 35 to 38, as old clients do), and scans in the requested
/// packets. A plain state machine.
///
/// For real robots the commands 35 and 37 have other meanings. Therefore 37 with 0, 1 or 2 sets the end of
/// the field of view only directly after 36 has set its start, as old clients do it; 35 switches the laser
/// only with 0, 1 or 2.
class LaserService {
 public:
  /// Without a laser every command is refused.
  explicit LaserService(std::optional<ServerSettings::Laser> laser) : laser_(laser) { restore(); }

  /// Processes a command; returns false if it is not for the laser.
  bool obey(const Command& command);
  /// Returns to the state at power-up: off, full field of view, 1 degree resolution.
  void restore();

  bool isOn() const { return laser_ && mode_ != Mode::kOff; }
  /// The number of readings in a scan as the client configured it.
  int readings() const;
  /// Splits a scan into packets. `ranges` are all readings of the device, m, counterclockwise; the
  /// odometry's pose and `moved` go into the packets. Empty if the laser is off.
  std::vector<Packet> packets(std::span<const double> ranges, const Pose2& odometry, bool moved) const;

 private:
  /// The kind of packets that the client wants; the values are those of the command.
  enum class Mode : std::uint8_t { kOff = 0, kPlain = 1, kExtended = 2 };
  /// The range of one of the client's readings: that of the nearest reading of the device.
  int rangeMm(std::span<const double> ranges, int reading) const;

  const std::optional<ServerSettings::Laser> laser_;
  Mode mode_ = Mode::kOff;
  /// The client's field of view and resolution, deg.
  double startDeg_ = 0, endDeg_ = 0, incrementDeg_ = 0;
  /// The last command was the old client's start of the field of view; its end follows.
  bool endFollows_ = false;
};

}  // namespace robotlink::arcos
