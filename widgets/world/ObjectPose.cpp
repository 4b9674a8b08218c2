// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/ObjectPose.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/world/SceneState.h"

namespace widgets {

ObjectPose objectPose(const robotlink::Pose3& pose) {
  const auto& at = pose.translation();
  const Eigen::Matrix3d r = pose.linear();
  return {at.x(),
          at.y(),
          at.z(),
          std::atan2(r(2, 1), r(2, 2)),
          std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
          std::atan2(r(1, 0), r(0, 0))};
}

const robotcontrol::WorldObject* worldObject(robotlink::Session& session, const std::string& path) {
  const auto* all = session.store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                         session.timeline().newest());
  if (all == nullptr || path.empty()) return nullptr;
  const auto found = std::ranges::find(all->objects(), path, &robotcontrol::WorldObject::path);
  return found == all->objects().end() ? nullptr : &*found;
}

std::optional<robotlink::Pose3> worldPose(const robotcontrol::WorldObject& object, const SceneState& scene) {
  if (!object.has_pose_in_frame()) return std::nullopt;
  const auto frame = scene.framePose(object.frame());
  if (!frame) return std::nullopt;
  return *frame * robotlink::pose3(object.pose_in_frame());
}

robotcontrol::Request placeRequest(const std::string& model, const robotlink::Pose3& pose) {
  // A height of 0 would leave the model as high and as tilted as it is.
  constexpr double kOnGround = 1e-9;
  const ObjectPose numbers = objectPose(pose);
  robotcontrol::Request request;
  auto& place = *request.mutable_place_model();
  place.set_model(model);
  place.mutable_pose_in_field()->set_x(numbers[0]);
  place.mutable_pose_in_field()->set_y(numbers[1]);
  place.mutable_pose_in_field()->set_heading(numbers[5]);
  place.set_height(numbers[2] == 0 ? kOnGround : numbers[2]);
  place.set_roll(numbers[3]);
  place.set_pitch(numbers[4]);
  return request;
}

}  // namespace widgets
