// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "robotlink/base/Error.h"
#include "robotlink/session/Settings.h"

namespace robotlink {
class Session;
}

namespace app {

/// Decides how much of what robots have sent is kept to look back at it: in memory, and the older part on
/// disk. Both are settings that are remembered. GUI thread; the session must outlive it.
class HistoryKeeper {
 public:
  static constexpr std::uint64_t kMinMemory = std::uint64_t{64} << 20U;
  static constexpr std::uint64_t kMaxMemory = std::uint64_t{1} << 40U;

  /// `file`: where the settings are.
  HistoryKeeper(robotlink::Session& session, std::filesystem::path file);
  ~HistoryKeeper();

  /// Whether what is open sends something that nothing else keeps, in contrast to logs.
  void setLive(bool live);

  /// In bytes; less takes effect in the following ticks. Fails if that makes no sense, or if it cannot be
  /// remembered.
  robotlink::Result<void> setMemory(std::uint64_t bytes);
  /// 0: nothing is put on disk.
  robotlink::Result<void> setDisk(std::uint64_t bytes);
  std::uint64_t memory() const;
  std::uint64_t disk() const;

  /// Whether what no longer fits into memory is lost now, since too much waits to be written to disk.
  bool isLosing() const;
  /// Returns, once, why nothing more is put on disk, a part is lost, or the settings could not be read.
  std::optional<robotlink::Error> takeProblem();

 private:
  robotlink::Session& session_;
  robotlink::Settings settings_;
  std::optional<robotlink::Error> problem_;
};

}  // namespace app
