// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"

namespace foxglove {
class FrameTransforms;
class SceneEntity;
class SceneUpdate;
}  // namespace foxglove
namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The world at the instant that is shown, as the streams "scene" and "transforms" tell it: what there is,
/// and where. All poses are in the field's frame. Valid until the next update(). GUI thread.
class SceneState {
 public:
  struct Item {
    const foxglove::SceneEntity* entity = nullptr;
    std::string model;  ///< the movable model it is part of; empty: it is part of the field
    robotlink::PackagePtr keep;
  };

  void update(const robotlink::StreamStore& store, robotlink::Instant shown);

  /// By the entities' ids.
  const std::map<std::string, Item>& items() const { return items_; }
  /// Grows when items() changed.
  std::uint64_t itemsVersion() const { return itemsVersion_; }

  /// The pose of a frame in the field's frame; that of the field itself is the identity.
  std::optional<robotlink::Pose3> framePose(const std::string& frame) const;
  /// What can be moved, by name.
  const std::vector<std::string>& models() const { return models_; }
  /// The frame of a model: that of its name or, without one, its first entity's; empty if there is none.
  std::string modelFrame(const std::string& model) const;
  std::optional<robotlink::Pose3> modelPose(const std::string& model) const;

 private:
  void apply(const foxglove::SceneUpdate& update, const robotlink::PackagePtr& keep);
  void updateItems(const robotlink::StreamStore& store, robotlink::Instant shown);
  void updatePoses(const foxglove::FrameTransforms& transforms);
  void collectModels(const robotlink::StreamStore& store, robotlink::Instant shown);

  std::map<std::string, Item> items_;
  std::map<std::string, robotlink::Pose3> poses_;
  std::vector<std::string> models_;
  robotlink::PackagePtr newestScene_, transforms_, status_;
  std::uint64_t itemsVersion_ = 0;
};

}  // namespace widgets
