// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionFile.h"

// Changes to the text of a motion that leave everything else in it as it is: comments, blanks, the order of
// lines. `motion` is what was read of `text`; lines are numbered from 1, as in MotionLine::number. Each
// function returns the whole new text, and the old one if there is no such line, word or column.
namespace robotlink {

/// A key frame in the order of a motion's text: what a table or a timeline of key frames shows.
struct KeyFramePlace {
  /// The index of its line in MotionFile::lines, and its number in the text.
  std::size_t index = 0;
  int line = 0;
  /// When it begins if the lines are played in their order, without regard to transitions.
  Duration begin{};
};
std::vector<KeyFramePlace> keyFramesOf(const MotionFile& motion);
/// The key frame of one of its places.
const KeyFrame& keyFrameAt(const MotionFile& motion, const KeyFramePlace& place);

/// The text of a motion without key frames, which ends as motions do. `joints` become its columns.
std::string newMotion(const std::string& name, const std::vector<std::string>& joints);
/// The same motion under another name.
std::string withName(std::string_view text, const std::string& name);

/// Replaces a word of a line (counted from 0); columns of words stay aligned at their ends where there is
/// room.
std::string withWord(std::string_view text, int line, std::size_t word, std::string_view to);
// Replace a part of the key frame in that line.
std::string withValue(std::string_view text, const MotionFile& motion, int line, std::size_t column,
                      const JointValue& value);
std::string withInterpolation(std::string_view text, const MotionFile& motion, int line, int interpolation);
/// `duration` is rounded to the unit of the text, and is at least one of it.
std::string withDuration(std::string_view text, const MotionFile& motion, int line, Duration duration);

/// The line after which a key frame belongs that is added to the end: that of the last key frame, otherwise
/// of the last label, otherwise the last line.
int lastFrameLine(std::string_view text, const MotionFile& motion);
/// Inserts a key frame after a line; 0: at the beginning.
std::string withFrame(std::string_view text, const MotionFile& motion, int afterLine, const KeyFrame& frame);
std::string withoutLine(std::string_view text, int line);
/// Exchanges two lines.
std::string withLinesSwapped(std::string_view text, int a, int b);

/// The counterpart of a joint when a motion is mirrored at the robot's plane of symmetry.
struct MirroredJoint {
  std::string joint;       ///< the joint that moves like this one in the mirror
  bool isNegated = false;  ///< whether its angle has the other sign there
};
/// Mirrors the key frames and hardness lines of a motion, or the one line that is given. `mirror` has an
/// entry for each column of the motion. Fails if a column has its partner not among the columns.
Result<std::string> mirrored(std::string_view text, const MotionFile& motion,
                             const std::vector<MirroredJoint>& mirror, std::optional<int> line = {});

}  // namespace robotlink
