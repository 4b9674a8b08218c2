// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionFile.h"

namespace robotlink {

/// Limits of the robots' original motion compilers.
inline constexpr int kMaxMotionFiles = 500;
inline constexpr int kMaxMotionLines = 32000;
inline constexpr int kMaxMotionLabels = 5000;
/// The largest angle of a data line in either direction.
inline constexpr double kMaxMotionDegrees = 210;

/// Reads the text of a motion (`.mof`): `motion_id = NAME`, `label`, `transition`, `hardness` and data lines;
/// comments extend from `"` or `//` to the end of the line.
///
/// Three more header lines are our own and absent from original files: `joints = NAME...` names the columns,
/// `units = deg|mrad` and `time = ms|ticks` set the units (default: degrees and milliseconds). Without
/// `joints` the columns are the argument `joints` or, if that is empty, as many as the first data line has.
/// Never crashes on any text: returns a motion or all errors with file, line and column. Ids begin with
/// "motion.".
tl::expected<MotionFile, Errors> readMotion(std::string_view text, const std::string& path,
                                            const std::vector<std::string>& joints = {});

/// The readable part of a text, and all errors; lines with errors are missing in the motion.
struct MotionParse {
  MotionFile motion;
  Errors errors;
};
/// Reads a motion for an editor, which shows what can be read of a text with errors.
MotionParse parseMotion(std::string_view text, const std::string& path,
                        const std::vector<std::string>& joints = {});

/// Reads a motion from a file; fails also if that cannot be read.
tl::expected<MotionFile, Errors> readMotionFile(const std::filesystem::path& file,
                                                const std::vector<std::string>& joints = {});

}  // namespace robotlink
