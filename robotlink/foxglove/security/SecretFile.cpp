// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/SecretFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/base/UnfinishedFile.h"

namespace robotlink::websocket {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSecret = 1U << 20U;

tl::unexpected<Error> secretFailure(const std::string& action, const fs::path& path, int reason) {
  return failure("secret.io", "cannot " + action + ": " + std::strerror(reason), {path.string(), 0, 0});
}

bool writeWhole(int file, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(file, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0;
}

/// Writes a file with mode 0600 beside a path, in a folder that is created if there is none; `temporary` is
/// its name then.
Result<void> writeBeside(const fs::path& path, std::string_view contents, std::string& temporary) {
  std::error_code error;
  if (const fs::path folder = path.parent_path(); !folder.empty() && fs::create_directories(folder, error))
    fs::permissions(folder, fs::perms::owner_all, error);
  temporary = path.string() + ".XXXXXX";
  const int file = ::mkostemp(temporary.data(), O_CLOEXEC);  // with mode 0600
  if (file < 0) return secretFailure("create a temporary file beside it", path, errno);
  const UnfinishedFile unfinished(temporary);
  const bool isWritten = writeWhole(file, contents);
  const int reason = errno;
  ::close(file);
  if (isWritten) return {};
  ::unlink(temporary.c_str());
  return secretFailure("write", path, reason);
}

}  // namespace

fs::path stateDirectory() {
  if (const char* state = environmentValue("XDG_STATE_HOME")) return fs::path(state) / "robotcontrol";
  if (const char* home = environmentValue("HOME")) return fs::path(home) / ".local/state/robotcontrol";
  return fs::temp_directory_path() / ("robotcontrol-" + std::to_string(::getuid()));
}

Result<std::string> readSecret(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return secretFailure("open", path, errno);
  if (S_ISREG(status.st_mode) && status.st_uid != ::geteuid() && ::geteuid() != 0)
    return failure("secret.owner", "this file is a secret of another user; use a file of your own",
                   {path.string(), 0, 0});
  if (S_ISREG(status.st_mode) && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return failure("secret.readable",
                   "other users of this machine can read this secret: remove the file to have a new one "
                   "created, or if you are sure that nobody has read it, run chmod 600 on it",
                   {path.string(), 0, 0});
  return readFile(path, kMaxSecret);
}

Result<bool> createSecret(const fs::path& path, std::string_view contents) {
  std::string temporary;
  if (const auto written = writeBeside(path, contents, temporary); !written)
    return tl::unexpected(written.error());
  const UnfinishedFile unfinished(temporary);
  // A link, unlike a new name, never replaces a file that another process has created first.
  const bool isLinked = ::link(temporary.c_str(), path.c_str()) == 0;
  const int reason = errno;
  ::unlink(temporary.c_str());
  if (isLinked) return true;
  if (reason == EEXIST) return false;
  return secretFailure("write", path, reason);
}

Result<void> replaceSecret(const fs::path& path, std::string_view contents) {
  std::string temporary;
  if (auto written = writeBeside(path, contents, temporary); !written) return written;
  const UnfinishedFile unfinished(temporary);
  if (::rename(temporary.c_str(), path.c_str()) == 0) return {};
  const int reason = errno;
  ::unlink(temporary.c_str());
  return secretFailure("write", path, reason);
}

}  // namespace robotlink::websocket
