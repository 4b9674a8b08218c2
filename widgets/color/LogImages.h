// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Worker.h"
#include "widgets/color/ColorFrame.h"
#include "widgets/color/FrameSearch.h"

namespace widgets {

/// Reads a few images spread evenly over a stream of a log, in a thread of its own, so that a table can be
/// tried on what the user has not looked at. Called by one thread. The destructor cancels and waits for at
/// most one image.
class LogImages {
 public:
  /// The number of images to read; fewer if the stream has fewer, or some are damaged.
  static constexpr std::size_t kCount = 12;

  /// Begins at once. `stream`: the path of the images in the session.
  LogImages(LoggedImages images, std::string stream);

  /// The images, once, when they are read; none if the log cannot be read.
  std::optional<std::vector<ColorFramePtr>> take() { return worker_.take(); }

 private:
  std::vector<ColorFramePtr> read(const LoggedImages& images, const std::stop_token& stop) const;

  const std::string stream_;
  /// Its job: where the images are.
  robotlink::Worker<LoggedImages, std::vector<ColorFramePtr>> worker_;
};

}  // namespace widgets
