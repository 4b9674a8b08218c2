// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/CameraSettingsSender.h"

#include <fmt/format.h>

#include <algorithm>

#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace app {
namespace {

constexpr robotlink::Duration kSettingsPeriod = std::chrono::seconds(1);

}  // namespace

CameraSettingsSender::CameraSettingsSender(robotlink::Process& platform)
    : sender_(platform, robotlink::kCameraSettings.name, robotlink::Blocking::kNo) {}

bool CameraSettingsSender::isWanted() {
  // Cleared, so that the next receiver gets them at once.
  if (!sender_.connected()) sent_.clear();
  return sender_.connected();
}

void CameraSettingsSender::send(robotcontrol::CameraSettings settings, robotlink::Instant now) {
  std::string bytes = settings.SerializeAsString();
  if (bytes == sent_ && now - sentAt_ < kSettingsPeriod) return;
  sent_ = std::move(bytes);
  sentAt_ = now;
  robotlink::assign(*settings.mutable_timestamp(), now);
  sender_.send(std::make_shared<robotcontrol::CameraSettings>(std::move(settings)));
}

robotlink::Result<void> checkCameraSetting(const robotcontrol::CameraSettings& settings,
                                           const std::string& name, double value) {
  const auto found =
      std::ranges::find_if(settings.settings(), [&](const auto& s) { return s.name() == name; });
  if (found == settings.settings().end()) {
    std::vector<std::string> names;
    for (const auto& setting : settings.settings()) names.push_back(setting.name());
    return robotlink::failure("camera.setting",
                              "the camera has no setting '" + name + "'; it has " +
                                  (names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
  }
  if (!(value >= found->minimum() && value <= found->maximum()))
    return robotlink::failure("camera.setting", fmt::format("{} is {:g} to {:g}, not {:g}", name,
                                                            found->minimum(), found->maximum(), value));
  return {};
}

}  // namespace app
