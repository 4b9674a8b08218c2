// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/ProgramMaterials.h"

#include "app/core/own/WireSetups.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/MapConversions.h"

namespace app {

using robotlink::Errors;

namespace {

/// For a robot of a log, which no files describe.
tl::expected<ProgramMaterials, Errors> loggedMaterials(const robotcontrol::WireSetup& setup) {
  const auto& texts = setup.texts();
  auto description = robotlink::parseRobotDescription(texts.description().text(), texts.description().name());
  if (!description) return tl::unexpected(description.error());
  auto field = texts.field().text().empty()
                   ? tl::expected<robotlink::FieldDescription, Errors>(robotlink::FieldDescription())
                   : robotlink::FieldDescription::parse(texts.field().text(), texts.field().name());
  if (!field) return tl::unexpected(field.error());
  ProgramMaterials made;
  made.parameters.folder = parameterFolder(*description);
  made.robot = {setup.robot(), setup.team(), std::move(*description),
                std::make_shared<const robotlink::FieldDescription>(std::move(*field)), nullptr};
  if (setup.has_map())
    made.robot.map = std::make_shared<const robotlink::GroundMap>(robotlink::groundMap(setup.map()));
  made.layout = layoutIn(setup.layout());
  return made;
}

tl::expected<ProgramMaterials, Errors> materialsInFiles(const robotcontrol::WireSetup& setup) {
  ProgramMaterials made;
  auto description = readRobot(setup.kind());
  if (!description) return tl::unexpected(description.error());
  auto field = readField(setup.field_file());
  if (!field) return tl::unexpected(field.error());
  std::map<std::string, std::string> solutions;
  for (const auto& choice : setup.solutions()) solutions[choice.task()] = choice.solution();
  auto layout = readLayoutWith(setup.layout_file(), solutions);
  if (!layout) return tl::unexpected(layout.error());
  made.robot = {setup.robot(), setup.team(), **description, *field, nullptr};
  made.layout = std::move(*layout);
  made.parameters.folder = parameterFolder(**description);
  if (setup.map_file().empty()) return made;
  auto map = robotlink::GroundMap::load(setup.map_file());
  if (!map) return tl::unexpected(map.error());
  made.robot.map = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  return made;
}

}  // namespace

tl::expected<ProgramMaterials, Errors> programMaterials(const robotcontrol::WireSetup& setup) {
  auto made = setup.has_layout() ? loggedMaterials(setup) : materialsInFiles(setup);
  if (made) made->parameters.recorded.assign(setup.parameters().begin(), setup.parameters().end());
  return made;
}

}  // namespace app
