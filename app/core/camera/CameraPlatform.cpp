// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/camera/CameraPlatform.h"

#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace app {

CameraPlatform::CameraPlatform(const robotlink::Clock& clock, std::string robot, CameraAddress address,
                               VideoCalls& calls)
    : RealPlatform("platform", clock),
      robot_(std::move(robot)),
      reader_(std::move(address), clock, calls),
      image_(*this, robotlink::kCameraImage.name, robotlink::Blocking::kNo) {}

void CameraPlatform::actuate() {
  std::string state = reader_.state();
  if (state == reported_) return;
  reported_ = std::move(state);
  report(reported_ + ".");
}

void CameraPlatform::execute() {
  const auto shot = reader_.take();
  if (!shot) return;
  auto image = std::make_shared<foxglove::RawImage>();
  robotlink::assign(*image, shot->image.view(), shot->time, robot_ + "/camera");
  image_.send(std::move(image));
}

std::vector<RealPlatform::Figure> CameraPlatform::connectionFigures() const {
  const CameraReader::Counts counts = reader_.counts();
  return {{"images", counts.images},
          {"damaged_images", counts.damaged},
          {"replaced_images", counts.replaced},
          {"connections", counts.connections},
          {"losses", counts.losses}};
}

}  // namespace app
