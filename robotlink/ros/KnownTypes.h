// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "robotlink/process/Link.h"

namespace google::protobuf {
class Descriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink::ros {

/// A type of ROS for which there is a well-known schema of Foxglove with the same meaning, and that views,
/// searches for texts and exports of images know.
struct KnownType {
  /// The full name of the Protobuf type that RosType makes of it.
  std::string_view name;
  /// The type that it is converted to.
  const google::protobuf::Descriptor* (*target)();
  /// Converts a message. Fields that it lacks count as 0, or empty.
  PackagePtr (*convert)(const google::protobuf::Message& message);
};

/// The known type of this name ("sensor_msgs.Image"), or null. Any thread.
const KnownType* knownType(std::string_view name);

}  // namespace robotlink::ros
