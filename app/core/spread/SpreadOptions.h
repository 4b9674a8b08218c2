// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace app {

/// Selects the program of a layout that runs here, and how it finds the others over DDS. A plain value.
struct SpreadOptions {
  /// Its name in the layout; empty: the layout's processes all run in this program.
  std::string program = {};
  /// All programs run on this machine, whatever hosts the layout names.
  bool local = false;
  /// The DDS domain, in which programs see each other.
  std::uint32_t domain = 0;
};

}  // namespace app
