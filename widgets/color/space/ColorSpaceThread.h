// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "widgets/color/space/ColorSpaceScene.h"

namespace widgets {

/// Draws color spaces in a thread of its own. Latest wins: a request replaces one that has not begun. At most
/// about 33 pictures per second, and not more than half of one core.
///
/// All functions are called by the thread that made it. The destructor waits for the picture that is being
/// drawn.
class ColorSpaceThread {
 public:
  /// `finished` is called in the drawing thread when a picture can be taken; it must not block.
  explicit ColorSpaceThread(std::function<void()> finished);
  ~ColorSpaceThread();
  ColorSpaceThread(const ColorSpaceThread&) = delete;
  ColorSpaceThread& operator=(const ColorSpaceThread&) = delete;

  /// Replaces a request that has not begun.
  void request(std::shared_ptr<const ColorSpaceRequest> request);
  /// The newest picture that was not taken yet.
  std::optional<ColorSpacePicture> take();

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Waits for a request and until `due`. Null when the thread shall end.
  std::shared_ptr<const ColorSpaceRequest> next(Clock::time_point due);

  std::function<void()> finished_;
  /// Protects all following members but the thread.
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  std::shared_ptr<const ColorSpaceRequest> wanted_;
  std::optional<ColorSpacePicture> picture_;
  std::thread thread_;
};

}  // namespace widgets
