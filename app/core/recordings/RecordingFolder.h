// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// The recordings (.mcap) in a folder, as programs at the far end of a link see them: by the names of files,
/// and nothing else of the disk. Names with a path, hidden files and symbolic links are refused, since they
/// could lead out of the folder. Any thread; nothing is kept open.
class RecordingFolder {
 public:
  struct Entry {
    std::string name;
    std::uint64_t bytes = 0;
    /// The time of the last write, in seconds since 1970.
    double modified = 0;
    /// Whether it was ended as it should be, rather than by a crash; not while it is being recorded.
    bool isWhole = false;
    bool operator==(const Entry&) const = default;
  };
  struct Checksum {
    /// The number of bytes from the beginning: fewer than were requested if the file is shorter.
    std::uint64_t bytes = 0;
    /// CRC-32 as in zip and PNG, of the first bytes.
    std::uint32_t crc = 0;
  };
  /// The maximum number of bytes that read() returns.
  static constexpr std::uint64_t kMaxPiece = 1U << 20U;

  explicit RecordingFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Whether it is a name that a recording in such a folder can have: that of a file alone.
  static bool isName(const std::string& name);

  const std::filesystem::path& path() const { return folder_; }
  /// The newest first; empty if the folder does not exist.
  robotlink::Result<std::vector<Entry>> list() const;
  /// Up to `bytes` bytes at `offset`, fewer at the end of the file, at most kMaxPiece.
  robotlink::Result<std::string> read(const std::string& name, std::uint64_t offset,
                                      std::uint64_t bytes) const;
  /// Extends a checksum to the first `bytes` bytes, by at most `atMost` of them: long files are checked in
  /// steps.
  robotlink::Result<Checksum> extend(const std::string& name, Checksum before, std::uint64_t bytes,
                                     std::uint64_t atMost) const;
  robotlink::Result<void> remove(const std::string& name) const;

 private:
  /// The file of a name, if there is such a recording.
  robotlink::Result<std::filesystem::path> find(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace app
