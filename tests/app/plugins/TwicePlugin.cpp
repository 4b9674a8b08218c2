// SPDX-License-Identifier: GPL-3.0-or-later
// A plug-in for tests: it registers a command that there is already.
#include "robotlink/base/Plugin.h"
#include "robotlink/commands/CommandRegistration.h"

ROBOTCONTROL_PLUGIN("twice", "1", "Takes a name that is taken.") {
  static const robotlink::CommandRegistration kFirst{
      {{"twice.new", "Is new"}, [](auto&, const auto&) { return robotlink::Result<void>(); }}};
  static const robotlink::CommandRegistration kSecond{
      {{"robot.stop", "Is there already"}, [](auto&, const auto&) { return robotlink::Result<void>(); }}};
}
