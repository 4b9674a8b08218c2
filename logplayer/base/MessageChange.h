// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/base/Clock.h"

namespace google::protobuf {
class Descriptor;
class Message;
}  // namespace google::protobuf

namespace logplayer {

/// Adapts the contents of messages when logs are merged on one timeline: moves all fields of type
/// google.protobuf.Timestamp, and renames robots in frames of reference ("red1", "red1/camera" in the fields
/// frame_id, parent_frame_id, child_frame_id) and in fields `robot`. Uses reflection and thus works for
/// unknown types, too. Contents of bytes fields are not changed. One thread at a time; the descriptors of the
/// types must outlive this object.
class MessageChange {
 public:
  MessageChange() = default;
  /// `offset` is added to timestamps; `robots` maps old names to new ones.
  MessageChange(robotlink::Duration offset, std::map<std::string, std::string> robots)
      : offset_(offset), robots_(std::move(robots)) {}

  /// Whether no message would be changed.
  bool isNothing() const { return offset_.count() == 0 && robots_.empty(); }
  /// Whether messages of this type can contain something to change; the result is cached.
  bool concerns(const google::protobuf::Descriptor& type);
  /// Changes a message in place.
  void apply(google::protobuf::Message& message);
  /// Renames the robot in a frame of reference: "red1/camera" -> "red1-2/camera"; other names are returned
  /// unchanged.
  std::string renamed(const std::string& name) const;

 private:
  /// Whether the type, or a type of a field at any depth, can contain something to change.
  bool concernsFields(const google::protobuf::Descriptor& type);

  robotlink::Duration offset_{0};
  std::map<std::string, std::string> robots_;
  /// The results of concernsFields(), by type.
  std::map<const google::protobuf::Descriptor*, bool> concerned_;
};

}  // namespace logplayer
