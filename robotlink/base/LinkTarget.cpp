// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/LinkTarget.h"

#include <system_error>

namespace robotlink {

std::filesystem::path linkTarget(std::filesystem::path path) {
  constexpr int kMaxLinks = 40;  // the same limit as the system's
  for (int i = 0; i < kMaxLinks; ++i) {
    std::error_code error;
    if (!std::filesystem::is_symlink(path, error)) break;
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;  // an absolute one replaces the whole path
  }
  return path;
}

}  // namespace robotlink
