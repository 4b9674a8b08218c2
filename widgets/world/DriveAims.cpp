// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/DriveAims.h"

#include "robotcontrol/Driving.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {

std::optional<DriveAim> driveAim(const robotlink::StreamStore& store, const std::string& robot,
                                 robotlink::Instant shown) {
  const auto* path = store.latestAs<robotcontrol::DrivePath>(robot + "/" + robotlink::kDrivePath.name, shown);
  if (path == nullptr || !path->has_goal() || path->goal().cancelled()) return {};
  DriveAim aim;
  aim.robot = robot;
  aim.goal = robotlink::pose2(path->goal().pose_in_field());
  aim.anyHeading = path->goal().any_heading();
  aim.name = QString::fromStdString(path->goal().name());
  for (const auto& point : path->points_in_field()) aim.path.push_back(robotlink::vector2(point));
  aim.blocked = path->blocked();
  aim.reason = QString::fromStdString(path->reason());
  return aim;
}

}  // namespace widgets
