// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/own/OwnProgram.h"
#include "app/core/platform/HostingChoices.h"
#include "app/core/program/ProgramOverrides.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Logging.pb.h"

namespace app {

/// A log of a replay. A plain value.
struct ReplayLog {
  std::filesystem::path file;
  /// Added to the times of the log.
  robotlink::Duration offset{0};
  /// Whether the user chose the offset. Otherwise a log that does not overlap with the first one is shifted
  /// to begin with it, since the clocks of different computers do not agree.
  bool offsetChosen = false;
  /// The open file; null: it is opened.
  std::shared_ptr<logplayer::LogFile> opened = {};
};

/// The logs to replay, and how. A plain value.
struct ReplayOptions {
  /// Robots of equal names in several logs get "-2", "-3" and so on behind their names.
  std::vector<ReplayLog> logs;
  /// The layout of the programs that run on the logged data; empty: the one in each robot's log or, without
  /// one, that of the robot's kind.
  std::filesystem::path layout;
  /// Maps tasks to solutions, instead of the layout's.
  std::map<std::string, std::string> solutions;
  /// The user's earlier choices for the robots, by name.
  std::map<std::string, ProgramOverrides> overrides;
  /// Sources of packages, by "<robot>/<package>" or, for all robots, "*/<package>". For others the contents
  /// of the logs decide.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  /// Whether all packages that `packages` does not name are recomputed if possible.
  bool recomputeAll = false;
  /// A color table (.c64) for all robots; empty: the one in the log.
  std::filesystem::path colorTable;
  /// Whether the programs publish all packages that they yield, even if their debug keys are off.
  bool publishAllPackages = false;
  /// The time before the target of a jump for which the programs run, so that their models settle.
  robotlink::Duration preroll = std::chrono::seconds(2);
  /// The time that a module may take before it counts as not returning, in real time; 0: forever.
  std::chrono::milliseconds patience{0};
  /// The choice of programs that run in processes of the operating system of their own; always in lockstep.
  HostingChoices hosting = {};
  /// The options of running those.
  OwnProgram::Options own = {};
  /// Called while the logs are opened; can cancel that.
  logplayer::LogFile::Progress progress;
};

}  // namespace app
