// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class ColorTable;
}

namespace logplayer {

/// What became of the messages of an imported file.
struct ImportReport {
  std::string format;  ///< "B-Human message queue"
  std::uint64_t messages = 0;
  std::map<std::string, std::uint64_t> imported;       ///< by kind: "JPEGImage"
  std::map<std::string, std::uint64_t> notUnderstood;  ///< by kind, "id 123" where it has no name
  std::string damage;                                  ///< with the offset; empty if the file is whole
};

/// Whether a file is of an older format that importLog() reads, by its contents.
bool canImport(const std::filesystem::path& file);

/// Whether a robot may be called so: streams are called "<robot>/...".
bool isRobotName(std::string_view name);

struct ImportOptions {
  std::string robot = "nao";  ///< see isRobotName()
  /// Goes into the log as the one in force (app/core/ColorTables.h reads files of tables); null: none.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable;
  /// The share done in [0, 1]; false: give up.
  std::function<bool(double)> progress;
};

/// Converts a log of an older format into a new MCAP file, which must not exist. Begins with the set-up of a
/// program that suits such a log: the robot (resources/robots/nao.yaml), the field of its year, and a layout
/// of what can be done on it. Given up by progress (the error's id is "log.given-up"), or failed, nothing is
/// left.
robotlink::Result<ImportReport> importLog(const std::filesystem::path& from, const std::filesystem::path& to,
                                          const ImportOptions& options);

}  // namespace logplayer
