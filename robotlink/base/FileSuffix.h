// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace robotlink {

/// The suffix of a file's name in small letters, with its dot: ".map" for HOUSE.MAP, too. Files from systems
/// that do not tell small letters from capitals are recognized by it.
inline std::string fileSuffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::ranges::transform(suffix, suffix.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

}  // namespace robotlink
