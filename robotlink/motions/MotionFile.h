// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {

/// The entry of a key frame for one joint: an angle, no change (`*` or `~`), or release the joint (`-`).
struct JointValue {
  enum class Kind { kAngle, kKeep, kRelease };
  Kind kind = Kind::kKeep;
  double angle = 0;  ///< rad, for kAngle
  bool operator==(const JointValue&) const = default;
};

/// `label NAME`: a target of transitions.
struct MotionLabel {
  std::string name;
  bool operator==(const MotionLabel&) const = default;
};

/// `transition REQUEST MOTION LABEL`: continue at that label if REQUEST is the requested motion
/// ("allMotions": always).
struct MotionTransition {
  std::string request, motion, label;
  bool operator==(const MotionTransition&) const = default;
};

/// A data line: the joint angles to reach, and how long to take. Interpolation 0 jumps and then holds for the
/// duration, 1 is linear, 2 and 3 start and end softly (in the original they remove shaking).
struct KeyFrame {
  std::vector<JointValue> joints;
  int interpolation = 1;
  Duration duration{};
  bool operator==(const KeyFrame&) const = default;
};

/// `hardness V... TIME`: the share of each joint's torque, 0 to 1; nothing for `*` means full torque. It is
/// interpolated over TIME while the following lines are already being played.
struct MotionHardness {
  std::vector<std::optional<double>> shares;
  Duration duration{};
  bool operator==(const MotionHardness&) const = default;
};

/// An empty line, or one that holds only a comment.
struct MotionRemark {
  bool operator==(const MotionRemark&) const = default;
};

using MotionStatement = std::variant<MotionRemark, MotionLabel, MotionTransition, KeyFrame, MotionHardness>;

/// A line of a motion file.
struct MotionLine {
  MotionStatement statement;
  /// Includes the leading `"` or `//`; empty if there is none.
  std::string comment;
  /// Line number in the file, from 1; 0 if the line was never in a file.
  int number = 0;
  bool operator==(const MotionLine&) const = default;
};

/// A key-frame motion as written in its text (`.mof`), one object a line: what an editor edits and what
/// compileMotions() compiles. See robotlink/motions/MOTIONS.md.
///
/// Angles are in rad whatever the unit in the text. A plain value that knows no other files, so labels are
/// not checked here. The header lines (`motion_id`, and our own `joints`, `units`, `time`, `begin`,
/// `odometry`) are not in `lines`.
struct MotionFile {
  enum class AngleUnit { kDegrees, kMilliradians };
  enum class TimeUnit { kMilliseconds, kTicks };
  enum class Begin { kStand, kWalk };

  /// Only for error messages.
  std::string path;
  /// The name in the header line motion_id.
  std::string name;
  /// The joint of each column. Empty: the joints given to the reader, or merely counted.
  std::vector<std::string> joints;
  /// Whether the file itself names the columns, and in which line.
  bool hasJointHeader = false;
  int jointHeaderLine = 0;
  /// The units of numbers in the text.
  AngleUnit angleUnit = AngleUnit::kDegrees;
  TimeUnit timeUnit = TimeUnit::kMilliseconds;
  /// Whether a walking robot first stops, or begins the motion at the end of its step.
  Begin begin = Begin::kStand;
  /// The pose of the robot after the motion, in its frame before it: m, rad.
  Pose2 odometry;
  std::vector<MotionLine> lines;

  bool operator==(const MotionFile&) const = default;
};

/// The tick of the robots of 2002: one frame of joint angles.
inline constexpr Duration kMotionTick = std::chrono::milliseconds(8);

}  // namespace robotlink
