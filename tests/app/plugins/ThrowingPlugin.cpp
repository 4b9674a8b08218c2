// SPDX-License-Identifier: GPL-3.0-or-later
// A plug-in for tests: it registers a command, then throws.
#include <stdexcept>

#include "robotlink/base/Plugin.h"
#include "robotlink/commands/CommandRegistration.h"

ROBOTCONTROL_PLUGIN("throwing", "1", "Throws.") {
  static const robotlink::CommandRegistration kCommand{
      {{"throwing.command", "Never there"}, [](auto&, const auto&) { return robotlink::Result<void>(); }}};
  throw std::runtime_error("no license");
}
