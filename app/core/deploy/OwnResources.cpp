// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/deploy/OwnResources.h"

#include <cstdlib>

#include "robotlink/base/Resources.h"

namespace app {

namespace fs = std::filesystem;

robotlink::Result<void> useOwnResources(const fs::path& folder) {
  std::error_code error;
  fs::path whole = fs::absolute(folder, error).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // it ended with a slash
  const auto failed = [&](const std::string& what) {
    return robotlink::failure("deploy.resources", what + ": " + error.message(), {folder.string(), 0, 0});
  };
  if (error) return failed("this is not the path of a folder");
  if (!fs::exists(whole, error) || fs::is_empty(whole, error)) {
    if (const auto installed = robotlink::checkResources(); !installed) return installed;
    // Renamed when it is complete, so that one that was interrupted is not taken for the robot's.
    const fs::path copy = whole.string() + ".new";
    fs::remove_all(copy, error);
    fs::create_directories(copy, error);
    if (!error) fs::copy(robotlink::resourceDirectory(), copy, fs::copy_options::recursive, error);
    if (!error) fs::rename(copy, whole, error);
    if (error) return failed("the installed resources cannot be copied into this folder");
  }
  ::setenv("ROBOTCONTROL_RESOURCES", whole.c_str(), 1);
  return robotlink::checkResources();
}

}  // namespace app
