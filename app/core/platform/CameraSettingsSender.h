// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/process/Process.h"
#include "robotlink/process/Sender.h"

namespace app {

/// Sends the settings of a platform's camera while a client wants them: at once, when they change, and every
/// second. The platform must outlive it.
class CameraSettingsSender {
 public:
  explicit CameraSettingsSender(robotlink::Process& platform);

  robotlink::AnySender* sender() { return &sender_; }
  /// Whether a client wants them.
  bool isWanted();
  void send(robotcontrol::CameraSettings settings, robotlink::Instant now);

 private:
  robotlink::Sender<robotcontrol::CameraSettings> sender_;
  /// The settings that were sent last, without their time; empty: none.
  std::string sent_;
  robotlink::Instant sentAt_;
};

/// Fails with the reason unless there is a setting of this name with this value in its range.
robotlink::Result<void> checkCameraSetting(const robotcontrol::CameraSettings& settings,
                                           const std::string& name, double value);

}  // namespace app
