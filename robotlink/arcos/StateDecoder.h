// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/RobotState.h"
#include "robotlink/arcos/RobotType.h"
#include "robotlink/arcos/codec/StandardInformation.h"

namespace robotlink::arcos {

/// Makes the state of a robot of its information packets: SI units, an odometry that does not wrap, the
/// latest range of every sonar although a packet brings only some. One connection, one thread.
class StateDecoder {
 public:
  explicit StateDecoder(RobotType type);

  void take(const StandardInformation& information, Instant now);
  /// The robot was told to set its odometry to 0 at `now`: it will jump, within half a second.
  void expectReset(Instant now) { resetUntil_ = now + kResetTime; }

  const RobotState& state() const { return state_; }
  const RobotType& type() const { return type_; }

 private:
  static constexpr Duration kResetTime = std::chrono::milliseconds(500);

  void followOdometry(const StandardInformation& information, Instant now);
  void takeSonars(const StandardInformation& information, Instant now);

  RobotType type_;
  RobotState state_;
  struct Counts {
    int x = 0, y = 0;
  };
  std::optional<Counts> last_;  // of the last packet, as they were there
  std::optional<Instant> resetUntil_;
};

}  // namespace robotlink::arcos
