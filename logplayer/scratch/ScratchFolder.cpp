// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/scratch/ScratchFolder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace logplayer {
namespace {

constexpr char kLockFile[] = "scratch.lock";

/// Returns the descriptor of a file that is locked now; -1 if another program has locked it, or if it cannot
/// be opened.
int lockedFile(const std::filesystem::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), flags | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor < 0) return -1;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

void removeStale(const std::filesystem::path& parent) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(parent, error)) {
    if (!entry.path().filename().string().starts_with("robotcontrol-")) continue;
    const int lock = lockedFile(entry.path() / kLockFile, 0);
    if (lock < 0) continue;
    std::filesystem::remove_all(entry.path(), error);
    ::close(lock);
  }
}

}  // namespace

robotlink::Result<ScratchFolder> ScratchFolder::make() {
  auto folder = TemporaryFolder::make();
  if (!folder) return tl::unexpected(folder.error());
  removeStale(folder->path().parent_path());
  // The lock file gets its name only after it is locked, so that no program considers the folder abandoned.
  const auto unnamed = folder->path() / "new.lock", file = folder->path() / kLockFile;
  const int lock = lockedFile(unnamed, O_CREAT | O_EXCL);
  if (lock < 0 || ::rename(unnamed.c_str(), file.c_str()) != 0) {
    const std::string why = std::strerror(errno);
    if (lock >= 0) ::close(lock);
    return robotlink::failure("log.temporary", "no file can be made in the temporary folder: " + why,
                              {folder->path().string(), 0, 0}, {why});
  }
  return ScratchFolder(std::move(*folder), lock);
}

ScratchFolder::~ScratchFolder() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace logplayer
