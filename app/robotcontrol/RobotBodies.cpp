// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/RobotBodies.h"

#include <QColor>

#include "app/platforms/SceneMessages.h"
#include "foxglove/Scene.pb.h"
#include "simcore/ModelParts.h"
#include "widgets/world/RobotBody.h"

namespace app {
namespace {

std::shared_ptr<const widgets::RobotBody> readBody(const std::string& kind, const QColor& team) {
  const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
  const auto model = simcore::ModelParts::load(
      kind, robotlink::Rgb{channel(team.red()), channel(team.green()), channel(team.blue())});
  if (!model) return nullptr;
  auto body = std::make_shared<widgets::RobotBody>();
  body->parts = model->links;
  for (const auto& joint : model->joints)
    body->joints.push_back({joint.name, joint.parent, joint.child, joint.anchor, joint.axis, joint.usual});
  body->shapes = modelMessage(*model);
  return body;
}

}  // namespace

std::shared_ptr<const widgets::RobotBody> RobotBodies::of(const std::string& kind, const QColor& team) {
  const auto [found, isNew] = bodies_.try_emplace({kind, team.rgb()});
  if (isNew) found->second = readBody(kind, team);
  return found->second;
}

}  // namespace app
