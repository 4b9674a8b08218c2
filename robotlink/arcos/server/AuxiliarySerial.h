// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/GlobalPosition.h"

namespace robotlink::arcos {

/// The serial line AUX1 of the microcontroller, at which a GPS receiver is. A client asks for a number of
/// bytes (GETAUX) and is sent them as soon as that many have arrived. Reads no clock.
class AuxiliarySerial {
 public:
  /// The number of bytes that are kept; older ones that no client asks for are lost.
  static constexpr std::size_t kMaxWaiting = 1024;
  static constexpr int kMaxAsked = 200;

  /// The argument of GETAUX: from 1 to 200 bytes; 0, or anything else, drops what has arrived.
  void ask(int bytes);
  void receive(const std::string& bytes);
  /// The packet that was asked for, once it is complete.
  std::optional<AuxSerialPacket> take();
  void reset() { *this = {}; }

 private:
  std::string waiting_;
  std::size_t asked_ = 0;
};

/// A position as the sentence GGA of NMEA 0183, with checksum and line end; `time` is the time of the day.
std::string ggaSentence(const GlobalPosition& position, Duration time);

}  // namespace robotlink::arcos
