// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"

namespace foxglove {
class FrameTransform;
}
namespace google::protobuf {
class Message;
}
namespace robotlink {
class StreamStore;
}

namespace widgets {

/// The pose of the child frame in its parent.
robotlink::Pose3 poseInParent(const foxglove::FrameTransform& transform);

/// The transforms of a message of type FrameTransforms or FrameTransform; none of any other message.
std::vector<const foxglove::FrameTransform*> transformsOf(const google::protobuf::Message& message);

/// The frames of all streams of transforms but our own ("transforms"), such as tf and tf_static of a robot
/// with ROS: each transform holds until there is another one of the same child. Frames without a parent, such
/// as map, are where the world is. Each robot (streams::robotOf() of the streams' paths) has a
/// tree of its own, since robots give their frames the same names; streams without a robot, as in logs, share
/// one. GUI thread.
class FrameTree {
 public:
  struct Frame {
    std::string parent;
    robotlink::Pose3 inParent = robotlink::Pose3::Identity();
  };

  /// Reads the transforms up to an instant. Costs what was added since the last call; going back in time
  /// reads up to kMaxMessages of each stream again.
  void update(const robotlink::StreamStore& store, robotlink::Instant shown);
  /// All of a tree by the names of the children.
  using Frames = std::map<std::string, Frame>;
  /// In the frame without a parent; unset if the name is unknown, or if the frames form a cycle.
  /// Frames that the robot's own tree lacks are looked up in that of the streams without a robot; if the
  /// robot has no tree at all, also in the only one that there is.
  std::optional<robotlink::Pose3> pose(const std::string& robot, const std::string& frame) const;

  static constexpr std::size_t kMaxMessages = 5000;

 private:
  /// The data read of a stream: its newest message, at this time.
  struct Read {
    robotlink::PackagePtr newest;
    robotlink::Instant time;
  };
  static void add(Frames& frames, const robotlink::PackagePtr& message);

  /// Keyed by robot; empty: the streams without one.
  std::map<std::string, Frames> trees_;
  std::map<std::string, Read> read_;
  std::uint64_t generation_ = 0;
};

}  // namespace widgets
