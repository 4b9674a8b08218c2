// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Resources.h"

#include <cstdlib>

namespace robotlink {
namespace fs = std::filesystem;
namespace {

bool isResourceDirectory(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path / "robots", error) && fs::is_directory(path / "layouts", error);
}

}  // namespace

const char* environmentValue(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

fs::path resourceDirectory() {
  if (const char* chosen = environmentValue("ROBOTCONTROL_RESOURCES")) return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path installed = program.parent_path() / "../share/robotcontrol";
  if (isResourceDirectory(installed)) return fs::weakly_canonical(installed, error);
  for (fs::path folder = program.parent_path(); folder != folder.parent_path();
       folder = folder.parent_path()) {
    if (isResourceDirectory(folder / "resources")) return fs::weakly_canonical(folder / "resources", error);
  }
  return {};
}

Result<void> checkResources() {
  const fs::path found = resourceDirectory();
  if (isResourceDirectory(found)) return {};
  if (const char* chosen = environmentValue("ROBOTCONTROL_RESOURCES")) {
    return failure("resources.wrong",
                   std::string("the variable ROBOTCONTROL_RESOURCES names the folder '") + chosen +
                       "', but there are no folders 'robots' and 'layouts' in it; set it to the folder "
                       "'resources' of RobotControl, or unset it");
  }
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  return failure("resources.none",
                 "RobotControl's own files were not found: there is no folder 'resources' in or above '" +
                     folder.string() + "', and no '" +
                     (folder / "../share/robotcontrol").lexically_normal().string() +
                     "'; set the variable ROBOTCONTROL_RESOURCES to that folder");
}

fs::path resource(const fs::path& relative) {
  return resourceDirectory() / relative;
}

fs::path builtResource(const fs::path& relative) {
  std::error_code error;
  fs::path installed = resource(relative);
  if (fs::exists(installed, error)) return installed;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path(); folder != folder.parent_path();
       folder = folder.parent_path()) {
    if (fs::exists(folder / relative, error)) return folder / relative;
  }
  return installed;
}

fs::path userDirectory() {
  if (const char* config = environmentValue("XDG_CONFIG_HOME")) return fs::path(config) / "robotcontrol";
  if (const char* home = environmentValue("HOME")) return fs::path(home) / ".config/robotcontrol";
  return fs::temp_directory_path() / "robotcontrol";
}

}  // namespace robotlink
