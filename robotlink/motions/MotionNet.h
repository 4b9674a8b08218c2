// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionFile.h"

namespace robotlink {

/// A transition whose names are resolved.
struct MotionJump {
  static constexpr int kAllMotions = -1;
  int request = kAllMotions;  ///< index of a motion
  int target = 0;             ///< index of a node
};

/// All motions of a robot, compiled: labels are node numbers, columns are the robot's joints. What a
/// MotionPlayer plays.
///
/// Made by compileMotions() and immutable after that; any number of players on any threads share one.
/// The motion "extern" is the entry table: a request is looked up from its label "start" on, and every other
/// motion comes back to it at its end.
struct MotionNet {
  static constexpr const char* kEntryName = "extern";

  using Transition = MotionJump;
  using Step = std::variant<Transition, KeyFrame, MotionHardness>;
  struct Node {
    Step step;
    int motion = 0;  ///< which one it belongs to
    int line = 0;    ///< of that motion's file
  };

  std::vector<std::string> joints;
  std::vector<std::string> motions;
  std::vector<Node> nodes;
  int entry = 0;  ///< the node at extern's start

  /// Index of a motion, or -1.
  int find(std::string_view motion) const;
  /// The motions that can be asked for, those in the entry table, in its order.
  std::vector<std::string> requestable() const;
};

/// Compiles files to a net for a robot's joints. Columns that a file names are sought by name, others by
/// position. Checks what no file alone can: unknown motions, labels and joints, duplicates, lines that can
/// never be reached, motions that do not end in a transition, a missing extern.mof. All errors are returned,
/// with file and line.
tl::expected<std::shared_ptr<const MotionNet>, Errors> compileMotions(std::span<const MotionFile> files,
                                                                      const std::vector<std::string>& joints);

/// Reads and compiles every .mof of a folder.
tl::expected<std::shared_ptr<const MotionNet>, Errors> loadMotions(const std::filesystem::path& folder,
                                                                   const std::vector<std::string>& joints);

}  // namespace robotlink
