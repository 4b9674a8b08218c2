// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "colortool/samples/SampleFile.h"
#include "widgets/RecoveryFile.h"

namespace widgets {

/// Keeps unsaved samples in a recovery file, see RecoveryFile.
class ColorRecovery {
 public:
  ColorRecovery(std::filesystem::path folder, std::function<void(robotlink::Error)> failed)
      : place_(std::move(folder), ".samples", std::move(failed)) {}

  /// The samples that a crashed program left behind; unset if there are none. They stay in the file until
  /// keep() or drop(). A file that cannot be read whole is renamed, which the errors say.
  std::optional<robotlink::Result<colortool::ReadSamples>> left();
  /// Writes the samples to the file; replaces a job that has not begun.
  void keep(colortool::Samples samples);
  /// Deletes the file.
  void drop() { place_.drop(); }
  /// Blocks until all jobs are done.
  void finish() { place_.finish(); }

  const std::filesystem::path& file() const { return place_.file(); }

 private:
  RecoveryFile place_;
};

}  // namespace widgets
