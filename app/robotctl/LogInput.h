// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "logplayer/TemporaryFolder.h"
#include "robotlink/base/Error.h"

namespace app {

/// The log that an argument of a command names: a file, or with "-" what comes on standard input. Logs are
/// read to and fro, so that of standard input a copy is made, which goes with this.
class LogInput {
 public:
  /// Waits for the end of standard input. Fails if it cannot be copied, or at an interrupt (Ctrl-C).
  static robotlink::Result<LogInput> of(const std::string& argument);

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit LogInput(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
  std::optional<logplayer::TemporaryFolder> copy_;
};

}  // namespace app
