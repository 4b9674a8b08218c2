// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionFile.h"

namespace robotlink {

/// A transition with its names resolved to indices.
struct MotionJump {
  static constexpr int kAllMotions = -1;
  /// Index into MotionNet::motions, or kAllMotions.
  int request = kAllMotions;
  /// Index into MotionNet::nodes.
  int target = 0;
};

/// All motions of a robot, compiled: labels are node numbers, columns are the robot's joints. A MotionPlayer
/// plays it.
///
/// Built by compileMotions() and immutable from then on; any number of players in any threads share one. The
/// motion "extern" is the entry table: a request is looked up from its label "start" on, and every other
/// motion returns to it at its end.
struct MotionNet {
  static constexpr const char* kEntryName = "extern";

  using Transition = MotionJump;
  using Step = std::variant<Transition, KeyFrame, MotionHardness>;
  /// A line of a motion; playing continues with the next node unless a transition is taken.
  struct Node {
    Step step;
    /// Index of the motion that the node belongs to.
    int motion = 0;
    /// Line in that motion's file.
    int line = 0;
  };

  /// Names, in the order of angles and shares.
  std::vector<std::string> joints;
  /// How a motion moves the robot.
  struct Displacement {
    /// The pose of the robot afterward, in its frame before it: m, rad.
    Pose2 pose;
    /// How long the key frames of the motion take together.
    Duration duration{};
  };

  /// Names, in the order of the files.
  std::vector<std::string> motions;
  /// Each in the order of `motions`.
  std::vector<Displacement> displacements;
  std::vector<MotionFile::Begin> begins;
  std::vector<Node> nodes;
  /// The node at the label "start" of the motion "extern".
  int entry = 0;

  /// Returns the index of a motion; -1 if there is none of that name.
  int find(std::string_view motion) const;
  /// Returns the posture in which a motion begins; a stand if there is none of that name.
  MotionFile::Begin begin(std::string_view motion) const;
};

/// Compiles files into a net for a robot's joints. Columns that a file names are matched by name, others by
/// position. Checks what no file alone can: unknown motions, labels and joints, duplicates, unreachable
/// lines, motions that do not end in a transition, a missing extern.mof. Returns all errors, each with file
/// and line.
tl::expected<std::shared_ptr<const MotionNet>, Errors> compileMotions(std::span<const MotionFile> files,
                                                                      const std::vector<std::string>& joints);

}  // namespace robotlink
