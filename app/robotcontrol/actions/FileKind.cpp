// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FileKind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace app {
namespace {

constexpr std::array<std::string_view, 4> kScenes = {".sdf", ".world", ".xml", ".map"};
constexpr std::array<std::string_view, 4> kPictureSuffixes = {".png", ".jpg", ".jpeg", ".yuyv"};
constexpr std::array<std::string_view, 6> kColorTables = {".c64", ".tm", ".raw", ".cal", ".lut", ".bz2"};

std::string suffixOf(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

bool isIn(const auto& suffixes, const std::string& suffix) {
  return std::ranges::find(suffixes, suffix) != suffixes.end();
}

}  // namespace

FileKind kindOfFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::string suffix = suffixOf(file);
  if (isIn(kPictureSuffixes, suffix) || std::filesystem::is_directory(file, ignored))
    return FileKind::kPictures;
  if (isIn(kScenes, suffix)) return FileKind::kScene;
  if (isIn(kColorTables, suffix)) return FileKind::kColorTable;
  return suffix == ".yaml" ? FileKind::kLayout : FileKind::kLog;
}

bool isMap(const std::filesystem::path& file) {
  return suffixOf(file) == ".map";
}

}  // namespace app
