// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/camera/CameraPlatform.h"

#include <cmath>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace app {

CameraPlatform::CameraPlatform(const robotlink::Clock& clock, std::string robot, CameraAddress address,
                               VideoCalls& calls)
    : RealPlatform("platform", clock),
      robot_(std::move(robot)),
      reader_(std::move(address), clock, calls),
      image_(*this, robotlink::kCameraImage.name, robotlink::Blocking::kNo),
      settings_(*this) {}

void CameraPlatform::actuate() {
  for (std::string& why : reader_.takeRefusals()) report(std::move(why) + ".");
  const std::string problem = reader_.problem();
  std::string state = problem.empty() ? reader_.state() : problem;
  if (state == reported_) return;
  reported_ = std::move(state);
  if (problem.empty()) {
    report(reported_ + ".");
  } else {
    reportProblem(reported_ + ".");
  }
}

robotcontrol::CameraSettings CameraPlatform::settings() const {
  robotcontrol::CameraSettings settings;
  for (const CameraDevice::Control& control : reader_.controls()) {
    auto& setting = *settings.add_settings();
    setting.set_name(control.name);
    setting.set_title(control.title);
    setting.set_value(control.value);
    setting.set_minimum(control.minimum);
    setting.set_maximum(control.maximum);
    setting.set_step(control.step);
    setting.set_initial(control.initial);
  }
  return settings;
}

robotlink::Result<void> CameraPlatform::setCamera(const robotcontrol::SetCamera& details) {
  if (auto checked = checkCameraSetting(settings(), details.setting(), details.value()); !checked)
    return checked;
  reader_.set(details.setting(), static_cast<std::int32_t>(std::lround(details.value())));
  return {};
}

void CameraPlatform::execute() {
  if (settings_.isWanted()) settings_.send(settings(), clock().now());
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
