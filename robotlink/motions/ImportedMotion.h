// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/motions/MotionFile.h"

namespace robotlink {

/// A motion without key frames for an import: its name, columns and units, a comment that names the file, and
/// the label "start". finishImport() adds its end.
MotionFile beginImport(const std::string& path, std::vector<std::string> joints,
                       MotionFile::TimeUnit timeUnit);
void finishImport(MotionFile& motion);

}  // namespace robotlink
