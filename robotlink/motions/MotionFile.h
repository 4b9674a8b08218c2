// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink {

/// What a key frame says about one joint: an angle, nothing (`*` or `~`), or that it shall be let loose
/// (`-`).
struct JointValue {
  enum class Kind { kAngle, kKeep, kRelease };
  Kind kind = Kind::kKeep;
  double angle = 0;  ///< rad, for kAngle
  bool operator==(const JointValue&) const = default;
};

/// `label NAME`: where transitions lead to.
struct MotionLabel {
  std::string name;
  bool operator==(const MotionLabel&) const = default;
};

/// `transition REQUEST MOTION LABEL`: go there if REQUEST is what is wanted ("allMotions": always).
struct MotionTransition {
  std::string request, motion, label;
  bool operator==(const MotionTransition&) const = default;
};

/// A data line: angles to be reached, and in how much time. Interpolation 0 jumps and then holds for the
/// duration, 1 is linear, 2 and 3 are their de-shaken forms: here an interpolation that starts and ends
/// softly.
struct KeyFrame {
  std::vector<JointValue> joints;
  int interpolation = 1;
  Duration duration{};
  bool operator==(const KeyFrame&) const = default;
};

/// `hardness V... TIME`: share of the torque of each joint, 0 to 1, nothing for `*` (all of it); it changes
/// over TIME while the following lines are already played.
struct MotionHardness {
  std::vector<std::optional<double>> shares;
  Duration duration{};
  bool operator==(const MotionHardness&) const = default;
};

/// An empty line, or one with nothing but a comment.
struct MotionRemark {
  bool operator==(const MotionRemark&) const = default;
};

using MotionStatement = std::variant<MotionRemark, MotionLabel, MotionTransition, KeyFrame, MotionHardness>;

struct MotionLine {
  MotionStatement statement;
  std::string comment;  ///< from its `"` or `//` on; empty if there is none
  int number = 0;       ///< in the file, from 1; 0 if it was never in a file
  bool operator==(const MotionLine&) const = default;
};

/// A key-frame motion as its text (`.mof`) says it, one object a line: what an editor edits and
/// MotionCompiler compiles.
///
/// Angles are rad whatever the text's unit. Values only; knows nothing of other files, so labels are not
/// checked here. The header (`motion_id`, and our own `joints`, `units`, `time`) is not among the lines.
struct MotionFile {
  enum class AngleUnit { kDegrees, kMilliradians };
  enum class TimeUnit { kMilliseconds, kTicks };

  std::string path;  ///< for messages
  std::string name;  ///< motion_id
  /// Which joint each column is. Empty: as the caller of the reader said, or merely counted.
  std::vector<std::string> joints;
  bool hasJointHeader = false;
  int jointHeaderLine = 0;
  AngleUnit angleUnit = AngleUnit::kDegrees;
  TimeUnit timeUnit = TimeUnit::kMilliseconds;
  std::vector<MotionLine> lines;

  bool operator==(const MotionFile&) const = default;
};

/// A tick of robots of 2002: one frame of joint angles.
inline constexpr Duration kMotionTick = std::chrono::milliseconds(8);

/// The text of a motion; reading it gives the same object, apart from line numbers.
std::string writeMotion(const MotionFile& motion);

}  // namespace robotlink
