// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraOptions.h"

#include "app/platforms/camera/CameraPlatform.h"

namespace app {

RealRobotOptions cameraOptions(std::string url, VideoCalls& calls) {
  const auto parsed = parseCameraAddress(url);
  if (parsed) url = toString(*parsed);
  const auto platform = [url, &calls](const robotlink::Clock& clock, const std::string& robot,
                                      const robotlink::RobotDescription&) -> RealRobotOptions::Platform {
    auto address = parseCameraAddress(url);
    if (!address) return tl::unexpected(address.error());
    return std::make_unique<CameraPlatform>(clock, robot, std::move(*address), calls);
  };
  return {.adapter = kCameraAdapter,
          .url = url,
          .robot = "camera",
          .kind = "camera",
          .platform = platform,
          // The camera's pose is known from its description, not from joints.
          .program = {.solutions = {{"camera-pose", "mounted"}}}};
}

}  // namespace app
