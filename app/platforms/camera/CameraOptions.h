// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/platforms/camera/VideoCalls.h"
#include "app/platforms/real/RealRun.h"

namespace app {

/// The name of the PlatformAdapter of cameras.
inline constexpr char kCameraAdapter[] = "camera";

/// A camera of this computer, "camera:///dev/video0", with the robot program that sees its images. Its name
/// is "camera". An invalid address is refused when its platform is made. The calls must outlive it.
RealRobotOptions cameraOptions(std::string url, VideoCalls& calls = systemVideoCalls());

}  // namespace app
