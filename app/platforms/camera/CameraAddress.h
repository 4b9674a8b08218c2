// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/base/Error.h"

namespace app {

/// A camera of this computer and how it takes its images. A plain value.
struct CameraAddress {
  /// "/dev/video0".
  std::string device;
  /// The wanted size, pixels; 0: 640 x 480. The camera takes the nearest one that it has.
  int width = 0, height = 0;
  /// Images per second; 0: as many as the camera takes.
  double rate = 0;
  /// A pixel format by its four letters: "YUYV", "MJPG"; empty: the first that the camera has of those that
  /// can be decoded, uncompressed ones first.
  std::string format = {};
  /// Values of the camera's controls by their names in lower case with underscores: "exposure_auto".
  std::map<std::string, int> controls = {};
  bool operator==(const CameraAddress&) const = default;
};

/// Whether a source means a camera: "camera:///dev/video0?size=640x480&rate=30", or in short "/dev/video0".
bool isCameraAddress(const std::string& source);
/// Reads such an address: after the device `size`, `rate`, `format`, and any other name is a control. Fails
/// with what is wrong.
robotlink::Result<CameraAddress> parseCameraAddress(const std::string& source);
/// The address in its usual form.
std::string toString(const CameraAddress& address);

}  // namespace app
