// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/scene/render/SceneFrame.h"
#include "widgets/world/RobotBeliefs.h"
#include "widgets/world/RobotBody.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

class SceneState;

/// Robots that no scene shows, as real ones and those of many logs, by their own models: the angles of their
/// joints come from what they report, and they stand upright where their drawings are placed; where no pose
/// is known, side by side at the field's center. With them, what their cameras see and their ranges.
/// Robots without a model (ViewContext::bodyOf) are left out. GUI thread.
class OwnModels {
 public:
  /// Finds the robots that the scene does not show, and requests what their models need.
  void update(const ViewContext& context, const SceneState& scene, const std::vector<RobotBelief>& beliefs,
              robotlink::Instant shown);
  bool empty() const { return robots_.empty(); }
  /// Their parts, and a floor of the size of a box below them; unset: no floor.
  std::vector<SceneBody> bodies(const std::optional<SceneBox>& ground);
  /// The pyramids of their cameras, half a meter long, and a line for each range.
  std::vector<SceneBody> sensors() const;
  /// The names, above them, of those whose true pose is not known; those without any pose say so.
  std::vector<SceneLabel> names() const;

 private:
  /// A model in the color of a team.
  struct Model {
    std::shared_ptr<const RobotBody> body;
    std::vector<std::shared_ptr<const SceneShape>> shapes;
  };
  struct Robot {
    std::string name;
    const Model* model = nullptr;
    bool isPoseKnown = false, isTruthKnown = false;
    robotlink::Pose3 inField = robotlink::Pose3::Identity();
    std::vector<robotlink::Pose3> parts;
    /// The message from which the parts were computed.
    robotlink::PackagePtr joints;
    std::shared_ptr<const SceneShape> sensors;
  };
  /// Makes a floor of that size, if it has another one.
  void makeFloor(const SceneBox& ground);
  /// Null if the kind has no model.
  const Model* modelOf(const ViewContext& context, const std::string& kind, const QColor& team);
  /// Recomputes parts and sensors of a robot if they have changed.
  static void readJoints(const robotlink::StreamStore& store, robotlink::Instant shown, Robot& robot);
  static void readSensors(const robotlink::StreamStore& store, robotlink::Instant shown,
                          const robotlink::RobotDescription* description, Robot& robot);

  /// Keyed by kind and color.
  std::map<std::pair<std::string, QRgb>, Model> models_;
  std::map<std::string, Robot> robots_;
  std::shared_ptr<const SceneShape> floor_;
  /// Its size.
  SceneBox floorBox_;
  PackageSubscription subscription_;
};

}  // namespace widgets
