// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "widgets/color/ColorSpaceScene.h"

namespace widgets {

/// Draws colour spaces in a thread of its own. Latest wins: a request replaces one that has not begun. At
/// most 30 pictures a second, and no more than half of one core.
///
/// The public functions may be called from the thread that made it. Its end waits for the picture that is
/// being drawn.
class ColorSpaceThread {
 public:
  /// `finished` is called from the thread when there is a picture to be taken; it must not wait.
  explicit ColorSpaceThread(std::function<void()> finished);
  ~ColorSpaceThread();
  ColorSpaceThread(const ColorSpaceThread&) = delete;
  ColorSpaceThread& operator=(const ColorSpaceThread&) = delete;

  void request(std::shared_ptr<const ColorSpaceRequest> request);
  /// The newest picture that was not taken yet.
  std::optional<ColorSpacePicture> take();

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  /// Null when the thread shall end. Waits for a request, and until `due`.
  std::shared_ptr<const ColorSpaceRequest> next(Clock::time_point due);

  std::function<void()> finished_;
  std::mutex mutex_;  // protects all that follows but the thread
  std::condition_variable changed_;
  bool ending_ = false;
  std::shared_ptr<const ColorSpaceRequest> wanted_;
  std::optional<ColorSpacePicture> picture_;
  std::thread thread_;
};

}  // namespace widgets
