// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "logplayer/base/TemporaryFolder.h"
#include "robotlink/base/Error.h"

namespace app {

/// The log that an argument of a command names: a file, or standard input for "-". Since logs need random
/// access, standard input is copied to a temporary file, which is removed with this object.
class LogInput {
 public:
  /// Blocks until the end of standard input. Fails if it cannot be copied, or if the user interrupts it
  /// (Ctrl-C).
  static robotlink::Result<LogInput> of(const std::string& argument);

  /// The file to read; valid as long as this object exists.
  const std::filesystem::path& path() const { return path_; }

 private:
  explicit LogInput(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
  /// Set only for standard input.
  std::optional<logplayer::TemporaryFolder> copy_;
};

}  // namespace app
