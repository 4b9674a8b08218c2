// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/Definition.h"

#include <array>
#include <string_view>

namespace robotlink::ros {

std::string structKey(const std::string& name) {
  std::string key = name;
  for (std::size_t at; (at = key.find("::")) != std::string::npos;) key.replace(at, 2, "/");
  constexpr std::array<std::string_view, 3> kFolders{"/msg/", "/srv/", "/action/"};
  for (const std::string_view folder : kFolders) {
    if (const auto at = key.find(folder); at != std::string::npos) return key.erase(at, folder.size() - 1);
  }
  return key;
}

}  // namespace robotlink::ros
