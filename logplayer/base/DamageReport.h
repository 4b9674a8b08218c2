// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "logplayer/mcap/read/Reader.h"

namespace logplayer {

/// Describes damage of a log file for the user: one sentence per place with file name and offset. If there
/// are very many, only the first ones.
std::vector<std::string> describeDamage(const std::filesystem::path& file, bool complete,
                                        const std::vector<mcap::Damage>& damage);

}  // namespace logplayer
