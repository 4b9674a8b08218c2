// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotcontrol {
class KeyTable;
}

namespace robotlink {

/// Named sets of modes of debug keys, as older versions saved them and as they are kept between runs
/// (Presets.h has what users save now): one text file each (<folder>/<name>.keys.json, with a version),
/// written as a whole or not at all. A preset is a KeyTable of which only names and modes count. Keys that
/// are off are not saved, so applying a preset switches all other keys off. Keys that the program does not
/// know (any longer) are kept. One thread at a time.
class KeyPresets {
 public:
  explicit KeyPresets(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Sorted; empty if the folder does not exist.
  std::vector<std::string> names() const;
  /// Fails if there is no such preset, or with the position of the error in its file.
  Result<robotcontrol::KeyTable> load(const std::string& name) const;
  /// Replaces a preset of the same name. Names consist of letters, digits, spaces, '-' and '_', at most 60
  /// characters.
  Result<void> save(const std::string& name, const robotcontrol::KeyTable& keys) const;
  Result<void> remove(const std::string& name) const;
  /// The file of a preset, which need not exist; fails if that can be no name.
  Result<std::filesystem::path> fileOf(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace robotlink
