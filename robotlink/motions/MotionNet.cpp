// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionNet.h"

#include <algorithm>

#include "robotlink/base/FileSuffix.h"
#include "robotlink/motions/MotionReader.h"

namespace robotlink {

int MotionNet::find(std::string_view motion) const {
  const auto found = std::find(motions.begin(), motions.end(), motion);
  return found == motions.end() ? -1 : static_cast<int>(found - motions.begin());
}

tl::expected<std::shared_ptr<const MotionNet>, Errors> loadMotions(const std::filesystem::path& folder,
                                                                   const std::vector<std::string>& joints) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    if (fileSuffix(i->path()) == ".mof") paths.push_back(i->path());
  }
  if (error) {
    return tl::unexpected(Errors{
        {"motion.unreadable", "the folder cannot be read: " + error.message(), {}, {folder.string(), 0, 0}}});
  }
  std::sort(paths.begin(), paths.end());
  if (paths.size() > kMaxMotionFiles) {
    return tl::unexpected(Errors{{"motion.too-many-files",
                                  "a robot has at most " + std::to_string(kMaxMotionFiles) + " motions",
                                  {},
                                  {folder.string(), 0, 0}}});
  }
  std::vector<MotionFile> files;
  Errors errors;
  for (const auto& path : paths) {
    auto file = readMotionFile(path, joints);
    if (file) {
      files.push_back(std::move(*file));
    } else {
      errors.insert(errors.end(), file.error().begin(), file.error().end());
    }
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return compileMotions(files, joints);
}

}  // namespace robotlink
