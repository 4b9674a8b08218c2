// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

/// The treatment of an element that SDFormat defines and the simulator does not support.
struct Unsupported {
  /// The consequence, for users; null if the element is supported, or means nothing here.
  const char* why = nullptr;
  /// Whether it is removed together with everything in it, unread.
  bool removed = false;
};

/// Looks an element up in the table of what is not supported and has a reason of its own. Elements whose
/// value says that they change nothing ("self_collide" false) are not reported. `isUsual` says whether it has
/// the value that it would have if it were missing.
Unsupported unsupported(const tinyxml2::XMLElement& element, bool isUsual);

/// Whether an element of SDFormat is read in the element that contains it, or reported as a part of it. All
/// others are left out.
bool isRead(const tinyxml2::XMLElement& element);

/// Whether sensors of this type are read, and all of these types.
bool isKnownSensor(std::string_view type);
std::vector<std::string> knownSensors();
inline constexpr const char* kKnownSensors =
    "of sensors, camera, depth_camera, rgbd_camera, segmentation_camera, lidar, sonar, imu, contact, "
    "magnetometer, navsat, altimeter, in joints force_torque, and custom ones of the namespace "
    "urn:robotcontrol:sdf are known";

}  // namespace simcore
