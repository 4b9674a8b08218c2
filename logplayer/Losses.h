// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "logplayer/mcap/Reader.h"

namespace logplayer {

/// What is wrong with a log file in sentences for people, one for each place, with the file's name and the
/// offset; the first ones if there are very many.
std::vector<std::string> lossesOf(const std::filesystem::path& file, bool complete,
                                  const std::vector<mcap::Damage>& damage);

}  // namespace logplayer
