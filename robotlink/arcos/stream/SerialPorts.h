// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace robotlink::arcos {

/// A serial port of this machine, for people to choose.
struct SerialPort {
  std::string device;       // "/dev/ttyUSB0"
  std::string description;  // "FTDI FT232R USB UART (A50285BI)", or "built-in serial port"
  bool operator==(const SerialPort&) const = default;
};

/// The serial ports of this machine: adapters first, then Bluetooth, then what is built in, each by number.
/// Reads what Linux tells in `ttys`, and opens no port; ports without hardware are left out. Blocks for as
/// long as reading a few small files takes.
std::vector<SerialPort> serialPorts(const std::filesystem::path& ttys = "/sys/class/tty");

}  // namespace robotlink::arcos
