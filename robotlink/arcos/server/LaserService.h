// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/arcos/server/ServerSettings.h"

namespace robotlink::arcos {

/// The laser of MobileSim's family, which goes through the robot's own line: what a client set by the
/// commands 230 to 233, or by 35 to 38 as old clients do, and a scan as the packets that it wants. A plain
/// state machine.
///
/// Commands 35 and 37 mean something else to real robots. 37 with 0, 1 or 2 sets the laser's end only right
/// after 36 has set its start, as old clients do it; 35 switches the laser only with 0, 1 or 2.
class LaserService {
 public:
  explicit LaserService(std::optional<ServerSettings::Laser> laser) : laser_(laser) { restore(); }

  /// False if the command is none of the laser's.
  bool obey(const Command& command);
  /// As the robot begins: off.
  void restore();

  bool isOn() const { return laser_ && mode_ != Mode::kOff; }
  /// How many readings a scan has for the client.
  int readings() const;
  /// One scan; `ranges` is all that the device measured, m, the robot's pose that of its odometry.
  std::vector<Packet> packets(std::span<const double> ranges, const Pose2& odometry, bool moved) const;

 private:
  enum class Mode : std::uint8_t { kOff = 0, kPlain = 1, kExtended = 2 };
  int rangeMm(std::span<const double> ranges, int reading) const;

  const std::optional<ServerSettings::Laser> laser_;
  Mode mode_ = Mode::kOff;
  double startDeg_ = 0, endDeg_ = 0, incrementDeg_ = 0;
  bool endFollows_ = false;  ///< an old client has set the start and will set the end
};

}  // namespace robotlink::arcos
