// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionFile.h"

// Motions of other teams for the ERS-210, read as motions of our own (MOTIONS.md has the formats). Each has
// its file's name, the joints of the ERS-210 that it moves as columns, a label "start" before its key frames
// and a transition to the entry table behind them. Ids of errors begin with "motion.".
namespace robotlink {

/// A motion of the team rUNSWift (`.pos`): text, degrees, frames of 8 ms. Errors have line and column.
tl::expected<MotionFile, Errors> readPosMotion(std::string_view text, const std::string& path);

/// A motion of the team CMPack'02 (`.mot`): records of doubles in little-endian order. Legs are given by
/// angles, or by where the paws stand on the ground; the angles for these follow from the kinematics that the
/// team used. What cannot be converted is a comment in its line. Errors name the record.
tl::expected<MotionFile, Errors> readCmpackMotion(std::string_view bytes, const std::string& path);

/// Whether a file is of one of these formats, by its suffix.
bool isForeignMotion(const std::filesystem::path& file);
/// Reads a file of one of these formats, by its suffix.
tl::expected<MotionFile, Errors> importMotion(const std::filesystem::path& file);

/// A name of a motion from that of a file: characters that names of motions cannot have become '_'.
std::string motionNameOf(const std::filesystem::path& file);

}  // namespace robotlink
