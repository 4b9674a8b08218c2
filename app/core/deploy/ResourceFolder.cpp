// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/ResourceFolder.h"

#include <algorithm>
#include <array>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/foxglove/security/Digest.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using robotlink::failure;
using robotlink::Result;

/// An area of the resources: folder, depth of the paths, and suffixes. An empty suffix: any.
struct Area {
  const char* folder;
  int depth;
  std::array<const char*, 6> suffixes;
};

constexpr std::array kAreas{
    Area{"layouts", 2, {".yaml"}},
    Area{"parameters", 3, {".textproto"}},
    Area{"motions", 2, {".mof"}},
    Area{"presets", 2, {".json"}},
    Area{kColorTables, 2, {".c64", ".tm", ".raw", ".cal", ".lut", ".bz2"}},
};
constexpr std::size_t kMaxPath = 200;

bool isPlainName(const std::string& name) {
  const auto isPlain = [](unsigned char c) { return c > ' ' && c != 127 && c != '/' && c != '\\'; };
  return !name.empty() && name.front() != '.' && std::ranges::all_of(name, isPlain);
}

bool isIn(const Area& area, const fs::path& path) {
  const auto names = std::distance(path.begin(), path.end());
  return *path.begin() == area.folder && names == area.depth &&
         std::ranges::any_of(area.suffixes, [suffix = robotlink::fileSuffix(path)](const char* known) {
           return known != nullptr && suffix == known;
         });
}

}  // namespace

Result<void> ResourceFolder::check(const std::string& path) {
  const auto refused = [&] {
    return failure(
        "deploy.path",
        "'" + path.substr(0, kMaxPath) +
            "' is not allowed: robots take layouts/NAME.yaml, parameters/ROBOT/NAME.textproto, "
            "motions/NAME.mof, presets/ROBOT.preset.json and colortables/ROBOT.c64 (or another format of "
            "color tables)",
        {}, {path.substr(0, kMaxPath)});
  };
  if (path.empty() || path.size() > kMaxPath || path.find('\0') != std::string::npos) return refused();
  const fs::path split(path);
  for (const fs::path& name : split)
    if (!isPlainName(name.string())) return refused();
  if (split.string() != split.lexically_normal().string()) return refused();
  const bool isKnown = std::ranges::any_of(kAreas, [&](const Area& area) { return isIn(area, split); });
  return isKnown ? Result<void>() : refused();
}

Result<fs::path> ResourceFolder::find(const std::string& path) const {
  if (auto allowed = check(path); !allowed) return tl::unexpected(allowed.error());
  fs::path at = folder_;
  for (const fs::path& name : fs::path(path)) {
    at /= name;
    std::error_code error;
    if (fs::is_symlink(at, error))
      return failure("deploy.link",
                     "'" + path + "' leads through a symbolic link on the robot, and is not written", {},
                     {path});
  }
  return at;
}

Result<std::vector<ResourceFolder::Entry>> ResourceFolder::listWithoutDigests() const {
  std::vector<Entry> entries;
  for (const Area& area : kAreas) {
    std::error_code error;
    fs::recursive_directory_iterator file(folder_ / area.folder, error);
    if (error == std::errc::no_such_file_or_directory) continue;
    for (; !error && file != fs::recursive_directory_iterator(); file.increment(error)) {
      std::error_code gone;
      if (file.depth() >= area.depth - 1) file.disable_recursion_pending();
      if (file->is_symlink(gone) || !file->is_regular_file(gone)) continue;
      const std::string path = file->path().lexically_relative(folder_).generic_string();
      const std::uint64_t bytes = file->file_size(gone);
      if (!gone && check(path)) entries.push_back({path, bytes, {}});
      if (entries.size() > kMaxFiles)
        return failure("deploy.files", "there are too many files", {folder_.string(), 0, 0});
    }
    if (error)
      return failure("deploy.folder", "the resource folder cannot be read: " + error.message(),
                     {(folder_ / area.folder).string(), 0, 0});
  }
  std::ranges::sort(entries, {}, &Entry::path);
  return entries;
}

Result<std::vector<ResourceFolder::Entry>> ResourceFolder::list() const {
  auto entries = listWithoutDigests();
  if (!entries) return entries;
  // Files that cannot be read, or are too long to have been sent, have no digest, and differ from all.
  for (Entry& entry : *entries) {
    const auto contents = robotlink::readFile(folder_ / entry.path, kMaxFileBytes);
    if (contents) entry.sha256 = robotlink::websocket::sha256(*contents);
  }
  return entries;
}

Result<ResourceFolder::Entry> ResourceFolder::put(const std::string& path, std::string_view contents) const {
  const auto file = find(path);
  if (!file) return tl::unexpected(file.error());
  if (contents.size() > kMaxFileBytes)
    return failure("deploy.size",
                   "'" + path + "' is longer than " + std::to_string(kMaxFileBytes >> 20U) + " MiB", {},
                   {path});
  const auto entries = listWithoutDigests();
  if (!entries) return tl::unexpected(entries.error());
  std::uint64_t bytes = contents.size();
  std::size_t files = 1;
  for (const Entry& entry : *entries) {
    if (entry.path == path) continue;
    bytes += entry.bytes;
    ++files;
  }
  if (bytes > kMaxBytes || files > kMaxFiles)
    return failure("deploy.full", "the robot's resource folder is full: remove what is not needed there", {},
                   {path});
  if (const auto written = robotlink::writeFileAtomically(*file, contents); !written)
    return tl::unexpected(written.error());
  return Entry{path, contents.size(), robotlink::websocket::sha256(contents)};
}

}  // namespace app
