// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/motions/MotionNet.h"

namespace robotlink {

/// The texts of all motions of a robot: those of a folder, some replaced by others that a user is trying, and
/// some added. A motion that the entry table does not list is added to it when the motions are compiled, so
/// that it can be requested. A plain value.
class MotionLibrary {
 public:
  struct Entry {
    std::string name;
    std::string text;
    /// Names the text in errors: the path of the file, or "NAME.mof" for one that is not from the folder.
    std::string path;
    /// Whether the text is not that of the folder.
    bool isReplaced = false;
  };
  /// The longest text of a motion that is taken, bytes.
  static constexpr std::size_t kMaxTextBytes = std::size_t{1} << 20U;

  /// The .mof files of a folder, by their motion_id. Fails if the folder, or a file in it, cannot be read.
  static tl::expected<MotionLibrary, Errors> load(const std::filesystem::path& folder);

  /// Replaces a motion, or adds one; an empty text removes the replacement again.
  void replace(const std::string& name, std::string text);

  /// Sorted by name.
  const std::vector<Entry>& entries() const { return entries_; }
  /// Null if there is none.
  const Entry* find(const std::string& name) const;

  /// Compiles all motions for a robot's joints.
  tl::expected<std::shared_ptr<const MotionNet>, Errors> compile(
      const std::vector<std::string>& joints) const;

 private:
  std::vector<Entry> entries_;
  /// The texts of the folder that were replaced.
  std::vector<Entry> replaced_;
};

/// Reads and compiles all .mof files of a folder.
tl::expected<std::shared_ptr<const MotionNet>, Errors> loadMotions(const std::filesystem::path& folder,
                                                                   const std::vector<std::string>& joints);

}  // namespace robotlink
