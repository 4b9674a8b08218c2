// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "app/core/platform/CameraSettingsSender.h"
#include "app/platforms/camera/CameraReader.h"
#include "app/platforms/real/RealPlatform.h"
#include "foxglove/Image.pb.h"

namespace app {

/// The platform of a camera of this computer: sends its images, in real time, and moves nothing. Its clock
/// must outlive it.
class CameraPlatform final : public RealPlatform {
 public:
  CameraPlatform(const robotlink::Clock& clock, std::string robot, CameraAddress address,
                 VideoCalls& calls = systemVideoCalls());

  /// Reports changes of the connection, and settings that the camera refused.
  void actuate() override;
  void engageStop(bool engaged) override { stopEngaged_ = engaged; }
  bool stopEngaged() const override { return stopEngaged_; }
  std::string refusal() const override { return "a camera moves nothing"; }
  robotlink::Result<void> setCamera(const robotcontrol::SetCamera& details) override;
  std::vector<robotlink::AnySender*> onRequest() override { return {settings_.sender()}; }
  void connectNow() override { reader_.openNow(); }
  bool isConnected() const override { return reader_.isOpen(); }
  std::string connectionText() const override { return reader_.state(); }
  std::vector<Figure> connectionFigures() const override;

 protected:
  /// Sends the newest image, if there is one since the last call.
  void execute() override;

 private:
  robotcontrol::CameraSettings settings() const;

  const std::string robot_;
  std::atomic<bool> stopEngaged_{false};
  std::string reported_;
  CameraReader reader_;
  robotlink::Sender<foxglove::RawImage> image_;
  CameraSettingsSender settings_;
};

}  // namespace app
