// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/platforms/camera/CameraAddress.h"
#include "app/platforms/camera/VideoCalls.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"

namespace app {

/// A camera of this computer that takes images, over Video4Linux 2 (the kernel's user space API, "Video
/// Capture Interface" and "User Controls"). One thread. The calls must outlive it.
class CameraDevice {
 public:
  /// A setting of the camera, such as its exposure time.
  struct Control {
    std::uint32_t id = 0;
    /// The name in CameraAddress::controls, and the name that the driver uses.
    std::string name, title;
    std::int32_t minimum = 0, maximum = 0, step = 1, initial = 0, value = 0;
  };
  /// How it takes images, which may differ from what was requested.
  struct Mode {
    int width = 0, height = 0;
    /// Four letters.
    std::string format;
    /// Images per second; 0: unknown.
    double rate = 0;
  };

  /// Opens the camera and lets it take images. Fails with the reason: no such device, no permission, busy, no
  /// camera, no format that can be decoded, no such control.
  static robotlink::Result<std::unique_ptr<CameraDevice>> open(const CameraAddress& address,
                                                               VideoCalls& calls = systemVideoCalls());
  ~CameraDevice();
  CameraDevice(const CameraDevice&) = delete;
  CameraDevice& operator=(const CameraDevice&) = delete;

  /// The newest image, waiting for one up to a time; empty if none came. Fails with "camera.damaged" if the
  /// image cannot be decoded, and the next one may be read; otherwise the camera is disconnected.
  robotlink::Result<std::optional<robotlink::Image>> next(int milliseconds);

  /// The driver's name of the camera.
  const std::string& title() const { return title_; }
  const Mode& mode() const { return mode_; }
  /// The controls with their values at the last refresh().
  const std::vector<Control>& controls() const { return controls_; }
  /// Asks for the values of all controls, of which the camera may change some by itself.
  void refresh();
  /// Fails if there is no such control, or if the camera refuses the value.
  robotlink::Result<void> set(const std::string& control, std::int32_t value);

 private:
  /// Memory of the device with an image.
  struct Buffer {
    void* memory = nullptr;
    std::size_t length = 0;
  };

  CameraDevice(std::string device, VideoCalls& calls) : device_(std::move(device)), calls_(calls) {}
  robotlink::Result<void> begin(const CameraAddress& address);
  robotlink::Result<void> identify();
  robotlink::Result<void> chooseMode(const CameraAddress& address);
  void chooseRate(double rate);
  void listControls();
  robotlink::Result<void> mapBuffers();
  robotlink::Result<const Control*> find(const std::string& control) const;
  /// An error with the reason of the operating system.
  robotlink::Error failed(const std::string& what) const;
  robotlink::Result<robotlink::Image> decode(std::span<const std::uint8_t> bytes) const;

  const std::string device_;
  VideoCalls& calls_;
  int file_ = -1;
  std::string title_;
  Mode mode_;
  /// Bytes from a row to the next, for uncompressed formats.
  int step_ = 0;
  std::vector<Control> controls_;
  std::vector<Buffer> buffers_;
  bool isStreaming_ = false;
};

/// The cameras of this computer: their devices and titles.
std::vector<std::pair<std::string, std::string>> camerasHere(VideoCalls& calls = systemVideoCalls());

}  // namespace app
