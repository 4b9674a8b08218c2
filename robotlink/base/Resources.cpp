// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Resources.h"

#include <cstdlib>
#include <string_view>

namespace robotlink {
namespace fs = std::filesystem;
namespace {

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

bool isResourceDirectory(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path / "robots", error) && fs::is_directory(path / "layouts", error);
}

}  // namespace

fs::path resourceDirectory() {
  if (const char* chosen = environment("ROBOTCONTROL_RESOURCES")) return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path installed = program.parent_path() / "../share/robotcontrol";
  if (isResourceDirectory(installed)) return fs::weakly_canonical(installed, error);
  for (fs::path folder = program.parent_path(); folder != folder.parent_path(); folder = folder.parent_path()) {
    if (isResourceDirectory(folder / "resources")) return folder / "resources";
  }
  return {};
}

fs::path resource(const fs::path& relative) { return resourceDirectory() / relative; }

fs::path userDirectory() {
  if (const char* config = environment("XDG_CONFIG_HOME")) return fs::path(config) / "robotcontrol";
  if (const char* home = environment("HOME")) return fs::path(home) / ".config/robotcontrol";
  return fs::temp_directory_path() / "robotcontrol";
}

}  // namespace robotlink
