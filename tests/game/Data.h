// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace game {

/// Where tests of logs and color tables take their data from: of real robots, beside the project, which may
/// be missing; or made up by tests/game, which are always there and have the same structure:
///
///     logs/bhuman2009.log
///     colour/bhuman2009/yuyv/NNN.yuyv, labels/NNN.png, tables/*.c64, timestamps_ms.txt
///     colour/nubots.lut, runswift.cal, upenn.raw, tekkotsu.tm, tekkotsu.col   (made ones only)
///
/// These are the parameters of such tests.
inline const std::vector<std::string> kSources{"real", "made"};

/// The folder of a source. The made data are written once for each program, which removes them at its end.
std::filesystem::path dataOf(const std::string& source);

/// The stems of the images that have labels, by their names.
std::vector<std::string> labeledStems(const std::filesystem::path& data);

}  // namespace game
