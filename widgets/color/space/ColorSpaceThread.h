// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "robotlink/base/Worker.h"
#include "widgets/color/space/ColorSpaceRenderer.h"
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

  /// Replaces a request that has not begun.
  void request(std::shared_ptr<const ColorSpaceRequest> request) { worker_.post(std::move(request)); }
  /// The newest picture that was not taken yet.
  std::optional<ColorSpacePicture> take() { return worker_.take(); }

 private:
  using Request = std::shared_ptr<const ColorSpaceRequest>;
  using Drawing = robotlink::Worker<Request, ColorSpacePicture>;

  void draw(Request request);

  /// Used by the drawing thread only, as is the time before which no picture must be begun.
  ColorSpaceRenderer renderer_;
  Drawing::Clock::time_point due_;
  Drawing worker_;
};

}  // namespace widgets
