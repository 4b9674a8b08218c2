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

/// What messages say of times and of robots, changed when logs are put on one time line: all fields of the
/// type google.protobuf.Timestamp are moved; frames of reference ("red1", "red1/camera" in fields frame_id,
/// parent_frame_id, child_frame_id) and fields `robot` get the robots' new names. By reflection, so for
/// unknown types, too. What lies in bytes stays as it is. One thread at a time; types must live as long.
class MessageChange {
 public:
  MessageChange() = default;
  MessageChange(robotlink::Duration offset, std::map<std::string, std::string> robots)
      : offset_(offset), robots_(std::move(robots)) {}

  bool isNothing() const { return offset_.count() == 0 && robots_.empty(); }
  bool concerns(const google::protobuf::Descriptor& type);
  void apply(google::protobuf::Message& message);
  /// "red1/camera" -> "red1-2/camera"; others as they are.
  std::string renamed(const std::string& name) const;

 private:
  bool concernsFields(const google::protobuf::Descriptor& type);

  robotlink::Duration offset_{0};
  std::map<std::string, std::string> robots_;
  std::map<const google::protobuf::Descriptor*, bool> concerned_;
};

}  // namespace logplayer
