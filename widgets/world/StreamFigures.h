// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace foxglove {
class SceneEntity;
class SceneUpdate;
}  // namespace foxglove
namespace google::protobuf {
class Message;
}
namespace robotlink {
class StreamStore;
}  // namespace robotlink

namespace widgets {

/// Messages of other programs as figures in the world: laser scans, clouds of points, poses, odometry, paths
/// and maps of cells (as ROS or Foxglove have them), frames as their axes, and scenes, into which markers of
/// ROS are converted. Messages of our own programs have views of their own, and are not included. GUI thread.
class StreamFigures {
 public:
  /// Whether a stream has figures, by its type, and unless its path is that of one of our own.
  static bool canShow(const std::string& path, const std::string& type);

  /// An entity, and the message that owns it.
  struct Figure {
    const foxglove::SceneEntity* entity = nullptr;
    robotlink::PackagePtr keep;
  };
  /// The figures of a stream at an instant. Converted again only where its message is another one.
  std::vector<Figure> of(const robotlink::StreamStore& store, const std::string& path,
                         robotlink::Instant shown);

 private:
  struct Shown {
    robotlink::PackagePtr message;
    robotlink::Instant time;
    std::uint64_t generation = 0;
    /// The figures left by the messages of a scene up to this one, by the entities' ids, with their times.
    std::map<std::string, std::pair<Figure, robotlink::Instant>> entities;
    /// The figure made of a message that is not a scene.
    std::shared_ptr<const foxglove::SceneUpdate> made;
  };
  static void addFrame(const std::string& frame, robotlink::Instant time, Shown& at);
  static void follow(const robotlink::StreamStore& store, const std::string& path, robotlink::Instant shown,
                     Shown& at);

  std::map<std::string, Shown> shown_;
};

/// The figure that is drawn for a message, in its frame; null: its type has none, or it is a scene itself.
std::shared_ptr<const foxglove::SceneUpdate> figureOf(const google::protobuf::Message& message);

}  // namespace widgets
