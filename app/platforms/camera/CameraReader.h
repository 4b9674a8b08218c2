// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/camera/CameraDevice.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/threads/PacedThread.h"

namespace app {

/// Reads a camera in a thread of its own: opens it, repeatedly where that fails or the camera was
/// unplugged, and keeps the newest image. Any thread may call. Only the destructor may block, up to 0.1 s.
/// Clock and calls must outlive it.
class CameraReader {
 public:
  /// An image, and when it was read.
  struct Shot {
    robotlink::Image image;
    robotlink::Instant time;
  };
  struct Counts {
    /// Images that were read, that could not be decoded, and that were replaced by newer ones unread.
    std::uint64_t images = 0, damaged = 0, replaced = 0;
    /// The number of times that the camera was opened, and lost after that.
    std::uint64_t connections = 0, losses = 0;
  };

  CameraReader(CameraAddress address, const robotlink::Clock& clock, VideoCalls& calls);
  ~CameraReader() = default;
  CameraReader(const CameraReader&) = delete;
  CameraReader& operator=(const CameraReader&) = delete;

  /// Removes and returns the newest image; empty if there is none since the last call.
  std::optional<Shot> take();
  bool isOpen() const { return isOpen_.load(); }
  /// The controls of the camera; none until it was opened once.
  std::vector<CameraDevice::Control> controls() const;
  /// Sets a control before the next image, and again whenever the camera is opened. Whether the camera
  /// accepts the value is in takeRefusals().
  void set(const std::string& control, std::int32_t value);
  /// Removes and returns why values were not accepted since the last call.
  std::vector<std::string> takeRefusals();
  /// The state as a sentence without its period.
  std::string state() const;
  /// Returns why there are no images, as such a sentence; empty if there are, or if it is not known yet.
  std::string problem() const;
  Counts counts() const;
  /// Ends the pause between two attempts to open the camera.
  void openNow();

 private:
  /// When the camera is opened next.
  robotlink::PacedThread::Clock::time_point due();
  /// Opens the camera and reads it for as long as that works.
  void step();
  /// Takes images of a camera that was just opened, until it is lost or the thread is to end.
  void use(CameraDevice& device);
  /// Reads until the camera is disconnected or the thread is to end; returns why.
  robotlink::Error read(CameraDevice& device);
  void setState(std::string state);
  /// Sets the state to what does not work.
  void setProblem(const std::string& why);
  /// Gives the camera the values that were set since the last call, and looks at all every second.
  void followControls(CameraDevice& device);

  const CameraAddress address_;
  const robotlink::Clock& clock_;
  VideoCalls& calls_;
  std::atomic<bool> isOpen_{false};
  mutable std::mutex mutex_;  // protects what follows
  bool now_ = false;
  std::optional<Shot> newest_;
  std::string state_;
  /// Whether the state is one in which there are no images.
  bool isProblem_ = false;
  Counts counts_;
  std::vector<CameraDevice::Control> controls_;
  /// All that were set, and those that the camera has not got yet.
  std::map<std::string, std::int32_t> chosen_, waiting_;
  std::vector<std::string> refusals_;
  /// Only the thread's, as is the next.
  robotlink::Instant refreshedAt_;
  /// The earliest time of the next attempt to open the camera, if openNow() does not end the pause.
  robotlink::PacedThread::Clock::time_point retryAt_;
  /// The last member, since the thread uses the others.
  robotlink::PacedThread thread_;
};

}  // namespace app
