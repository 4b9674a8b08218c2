// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace foxglove {
class RawImage;
}

namespace app {

/// Writes simulated images and their true classes as files for `robotctl color`: FOLDER/images/NAME.png in
/// color and FOLDER/labels/NAME.png with class numbers (TrueClasses), whose names are in a file beside them.
/// NAME consists of the robot and the simulated time in ms: "red1-001200". One thread.
class LabeledImages {
 public:
  /// Creates the folders; fails if they cannot be created or written to. Writes at most one image per robot
  /// and `period`.
  static robotlink::Result<LabeledImages> create(const std::filesystem::path& folder,
                                                 robotlink::Duration period);

  /// Writes an image and its classes, if it is due. After a failure nothing more is written.
  void add(const std::string& robot, const foxglove::RawImage& image, const foxglove::RawImage& classes);

  /// Number of images written.
  int written() const { return written_; }
  /// The first failure, if there was one.
  const robotlink::Result<void>& outcome() const { return outcome_; }

 private:
  robotlink::Result<void> write(const std::string& name, const foxglove::RawImage& image,
                                const foxglove::RawImage& classes) const;

  std::filesystem::path images_, labels_;
  robotlink::Duration period_{};
  /// Time of the next image, by robot.
  std::map<std::string, robotlink::Instant> due_;
  int written_ = 0;
  robotlink::Result<void> outcome_;
};

}  // namespace app
