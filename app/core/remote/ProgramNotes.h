// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace robotcontrol {
class ProgramSetup;
}
namespace robotlink {
class Session;
struct FieldDescription;
struct RobotDescription;
}  // namespace robotlink

namespace app {

struct LoadedPlatform;

/// The properties of a robot that views need in addition to its streams. A plain value; null: not known.
struct KnownRobot {
  std::shared_ptr<const robotlink::RobotDescription> description;
  std::shared_ptr<const robotlink::FieldDescription> field;
};

/// Publishes what the robots of a platform are, on their streams "program": their descriptions, their field,
/// and the layout. Remote clients of the session know it from these.
void publishPrograms(robotlink::Session& session, const LoadedPlatform& platform);

/// Reads what a robot is from its stream "program"; nothing if it cannot be read.
KnownRobot knownRobot(const robotcontrol::ProgramSetup& setup);

}  // namespace app
