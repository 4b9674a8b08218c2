// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/ProgramNotes.h"

#include "app/core/platform/PlatformFeed.h"
#include "app/core/program/RobotFiles.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotcontrol::ProgramSetup;

/// A file that cannot be read is left out.
void addFile(ProgramSetup::File& to, const std::filesystem::path& file) {
  if (file.empty()) return;
  const auto text = robotlink::readFile(file);
  if (!text) return;
  to.set_name(file.filename().string());
  to.set_text(*text);
}

}  // namespace

void publishPrograms(robotlink::Session& session, const LoadedPlatform& platform) {
  for (const auto& [name, description] : platform.robots) {
    const std::string path = name + "/" + robotlink::streams::kProgram;
    // The setup of a logged program is published with the log.
    if (session.store().find(path) != nullptr && platform.isLogged()) continue;
    auto setup = std::make_shared<ProgramSetup>();
    setup->set_robot(name);
    setup->set_is_body(platform.areBodies);
    if (!platform.areBodies) addFile(*setup->mutable_layout(), platform.layoutOf(name));
    if (description) addFile(*setup->mutable_description(), descriptionFile(description->name));
    if (platform.field) addFile(*setup->mutable_field(), fieldFileOf(*platform.field));
    session.push({path, session.store().newest(), std::move(setup)});
  }
}

KnownRobot knownRobot(const ProgramSetup& setup) {
  KnownRobot known;
  const ProgramSetup::File &robot = setup.description(), &field = setup.field();
  if (auto read = robotlink::parseRobotDescription(robot.text(), robot.name()))
    known.description = std::make_shared<const robotlink::RobotDescription>(std::move(*read));
  if (field.text().empty()) return known;
  if (auto read = robotlink::FieldDescription::parse(field.text(), field.name()))
    known.field = std::make_shared<const robotlink::FieldDescription>(std::move(*read));
  return known;
}

}  // namespace app
