// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"
#include "robotlink/process/Link.h"

namespace robotlink::ros {

/// The full name of the Protobuf type for one of ROS: "sensor_msgs.Image" for "sensor_msgs/msg/Image".
/// RosType has another one if it is that of one of this program's types.
std::string protobufName(const std::string& name);

/// The type of the messages of a ROS topic: a Protobuf type built from their definition, so that everything
/// that shows, plots, searches or exports Protobuf messages supports them, too. Times and durations become
/// those of Protobuf, uint8[] becomes bytes, and constants in front of a field the names of its values.
///
/// Input is untrusted: sizes and depth are limited. Immutable; any thread.
class RosType {
 public:
  /// `name` is the type's as the log or the server has it ("sensor_msgs/msg/Image"), `schemaEncoding` is
  /// "ros1msg", "ros2msg", "ros2idl" or "omgidl", `messageEncoding` "ros1" or "cdr". Fails if the definition
  /// has errors, or if an encoding is not one of these.
  static Result<std::shared_ptr<const RosType>> of(const std::string& name, std::string_view schemaEncoding,
                                                   std::string_view definition,
                                                   std::string_view messageEncoding);
  ~RosType();

  /// The full name of the Protobuf type: "sensor_msgs.Image".
  const std::string& name() const;
  /// Decodes a message, which keeps `type` alive.
  static Result<PackagePtr> read(const std::shared_ptr<const RosType>& type,
                                 std::span<const std::uint8_t> data);

 private:
  struct Implementation;
  explicit RosType(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::ros
