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

/// Sets of modes of debug keys under names that users give them, one text file each
/// (<folder>/<name>.keys.json, with a version), written whole or not at all. A preset is a KeyTable of which
/// only names and modes count; keys that are off are not saved, so whoever applies one switches all others
/// off. Keys that the program does not know (any more) are kept.
class KeyPresets {
 public:
  explicit KeyPresets(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// In order; empty if the folder does not exist.
  std::vector<std::string> names() const;
  /// Fails if there is none of that name, or with the place of what is wrong in its file.
  Result<robotcontrol::KeyTable> load(const std::string& name) const;
  /// Replaces one of that name. Names are of letters, digits, spaces, '-' and '_', 60 at most.
  Result<void> save(const std::string& name, const robotcontrol::KeyTable& keys) const;
  Result<void> remove(const std::string& name) const;

 private:
  Result<std::filesystem::path> fileOf(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace robotlink
