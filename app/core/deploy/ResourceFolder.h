// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// The files of a robot that others may replace over a link, in the robot's resource folder: layouts,
/// parameters, motions and color tables, by their paths in it ("layouts/compact.yaml"). All other files of
/// the folder are neither seen nor written. Paths out of it, hidden files and symbolic links are refused. Any
/// thread; nothing is kept open.
class ResourceFolder {
 public:
  struct Entry {
    std::string path;
    std::uint64_t bytes = 0;
    /// In hexadecimal digits.
    std::string sha256;
    bool operator==(const Entry&) const = default;
  };
  /// Limits of what others can fill the disk with.
  static constexpr std::uint64_t kMaxFileBytes = 2U << 20U, kMaxBytes = 64U << 20U;
  static constexpr std::size_t kMaxFiles = 2000;

  explicit ResourceFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }
  /// In the order of their paths. Fails if the folder cannot be read.
  robotlink::Result<std::vector<Entry>> list() const;
  /// Writes a file as a whole or not at all, in the place of one of that path. Fails, with what is allowed,
  /// if the path is not one of those above, or the file is too large.
  robotlink::Result<Entry> put(const std::string& path, std::string_view contents) const;
  /// Returns the location that a file of that path has, or would have.
  robotlink::Result<std::filesystem::path> find(const std::string& path) const;

  /// Whether a path is one of a layout, of parameters, a motion or a color table.
  static robotlink::Result<void> check(const std::string& path);

 private:
  /// The sizes of all files, by path.
  robotlink::Result<std::vector<Entry>> listWithoutDigests() const;

  std::filesystem::path folder_;
};

/// The folder of color tables in it; that of a robot is named after it: "colortables/red1.c64".
inline constexpr char kColorTables[] = "colortables";

}  // namespace app
