// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/TemporaryFolder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace logplayer {

robotlink::Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  std::string name = (parent / "robotcontrol-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    const std::string why = error ? error.message() : std::strerror(errno);
    return robotlink::failure("log.temporary",
                              "no temporary folder can be made: " + why + "; TMPDIR names the place",
                              {parent.string(), 0, 0}, {why});
  }
  return TemporaryFolder(name);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace logplayer
