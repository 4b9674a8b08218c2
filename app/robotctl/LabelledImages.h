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

/// Writes simulated images and their true classes as files that `robotctl color` reads:
/// FOLDER/images/NAME.png in colours and FOLDER/labels/NAME.png with the classes' numbers (TrueClasses),
/// whose names stand beside them. NAME is the robot and the simulated time in ms, "red1-001200". One thread.
class LabelledImages {
 public:
  /// Makes the folders; fails if they cannot be made or written to. At most one image of a robot is written
  /// each `period`.
  static robotlink::Result<LabelledImages> create(const std::filesystem::path& folder,
                                                  robotlink::Duration period);

  /// After something failed, nothing more is written.
  void add(const std::string& robot, const foxglove::RawImage& image, const foxglove::RawImage& classes);

  int written() const { return written_; }
  /// Fails if an image could not be written.
  const robotlink::Result<void>& outcome() const { return outcome_; }

 private:
  robotlink::Result<void> write(const std::string& name, const foxglove::RawImage& image,
                                const foxglove::RawImage& classes) const;

  std::filesystem::path images_, labels_;
  robotlink::Duration period_{};
  std::map<std::string, robotlink::Instant> due_;  // by robot
  int written_ = 0;
  robotlink::Result<void> outcome_;
};

}  // namespace app
