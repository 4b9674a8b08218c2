// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robotlink::arcos {

/// A serial port of this machine.
struct SerialPort {
  /// The device's path: "/dev/ttyUSB0".
  std::string device;
  /// For users: "FTDI FT232R USB UART (A50285BI)", or "built-in serial port".
  std::string description;
  bool operator==(const SerialPort&) const = default;
};

/// Lists the serial ports of this machine: adapters first, then Bluetooth, then built-in ports, each sorted
/// by number. Reads the descriptions that Linux provides in `ttys`, and opens no port; ports without hardware
/// are left out. Cost: reading a few small files.
std::vector<SerialPort> serialPorts(const std::filesystem::path& ttys = "/sys/class/tty");

}  // namespace robotlink::arcos
