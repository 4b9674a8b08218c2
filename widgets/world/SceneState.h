// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"
#include "widgets/world/FrameTree.h"

namespace foxglove {
class FrameTransforms;
class SceneEntity;
class SceneUpdate;
}  // namespace foxglove
namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The model that views show as the ball: scenes call it so.
inline constexpr char kBallModel[] = "ball";

/// The value of an entry of an entity's metadata; null if there is none.
const std::string* metadataOf(const foxglove::SceneEntity& entity, const char* key);

/// The world at the shown instant, from the streams "scene" and "transforms": which entities exist and where
/// they are. All poses are in the field's frame, in meters. References are valid until the next update(). GUI
/// thread.
class SceneState {
 public:
  /// An entity of the scene.
  struct Item {
    const foxglove::SceneEntity* entity = nullptr;
    /// Name of the movable model that the entity is part of; empty: it is part of the field.
    std::string model;
    /// The path of the object that it shows ("red1/link:head/visual:nose"); null: the scene does not say.
    std::shared_ptr<const std::string> object;
    /// The message that owns `entity`.
    robotlink::PackagePtr keep;
  };

  /// Reads the world from the history. Returns early where the messages are unchanged. If the history no
  /// longer reaches back to the scene, its oldest message counts.
  void update(const robotlink::StreamStore& store, robotlink::Instant shown);

  /// Keyed by the entities' ids.
  const std::map<std::string, Item>& items() const { return items_; }

  /// Pose of a frame in the field's frame; the identity for "field" and the empty name, unset for unknown
  /// frames. Frames of other programs (FrameTree) begin where the field does; `robot` is the one whose frame
  /// it is, empty if the stream that names the frame is of no robot.
  std::optional<robotlink::Pose3> framePose(const std::string& frame, const std::string& robot = {}) const;
  /// Names of the models that can be moved, sorted.
  const std::vector<std::string>& models() const { return models_; }
  /// Frame of a model: the one with its name or, without such, that of its first entity; empty if there is
  /// none.
  std::string modelFrame(const std::string& model) const;
  /// Unset if the model is unknown.
  std::optional<robotlink::Pose3> modelPose(const std::string& model) const;

 private:
  /// Applies deletions and entities of one message to items_.
  void apply(const foxglove::SceneUpdate& update, const robotlink::PackagePtr& keep);
  void updateItems(const robotlink::StreamStore& store, robotlink::Instant shown);
  void updatePoses(const foxglove::FrameTransforms& transforms);
  /// Updates models_ from the SimulationStatus and the items.
  void collectModels(const robotlink::StreamStore& store, robotlink::Instant shown);

  std::map<std::string, Item> items_;
  std::map<std::string, robotlink::Pose3> poses_;
  FrameTree tree_;
  std::vector<std::string> models_;
  /// The messages of the last update, to detect new ones.
  robotlink::PackagePtr newestScene_, transforms_, status_;
};

}  // namespace widgets
