// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FileKind.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "app/core/platform/PlatformAdapter.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/motions/MotionImport.h"

namespace app {
namespace {

constexpr std::array<std::string_view, 6> kColorTables = {".c64", ".tm", ".raw", ".cal", ".lut", ".bz2"};

bool isIn(const auto& suffixes, const std::string& suffix) {
  return std::ranges::find(suffixes, suffix) != suffixes.end();
}

}  // namespace

FileKind kindOfFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::string suffix = robotlink::fileSuffix(file);
  if (logplayer::isPictureFile(file) || std::filesystem::is_directory(file, ignored))
    return FileKind::kPictures;
  const PlatformAdapter* adapter = adapterFor(file.string());
  if (adapter != nullptr && adapter->time == TimeKind::kSimulated) return FileKind::kScene;
  if (isIn(kColorTables, suffix)) return FileKind::kColorTable;
  if (suffix == ".mof" || robotlink::isForeignMotion(file)) return FileKind::kMotion;
  return suffix == ".yaml" ? FileKind::kLayout : FileKind::kLog;
}

}  // namespace app
