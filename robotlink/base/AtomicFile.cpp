// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/AtomicFile.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "robotlink/base/LinkTarget.h"
#include "robotlink/base/UnfinishedFile.h"

namespace robotlink {
namespace {

tl::unexpected<Error> systemFailure(const char* action, const std::filesystem::path& path) {
  const std::string reason = std::strerror(errno);
  return failure("file.io", std::string("cannot ") + action + ": " + reason, {path.string(), 0, 0}, {reason});
}

bool writeAll(int file, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(file, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Result<std::string> readAll(int file, const std::filesystem::path& path, std::size_t maxBytes,
                            std::chrono::milliseconds pipePatience) {
  std::string contents;
  char buffer[1U << 16U];
  while (true) {
    // A file is always ready; a pipe whose writer sleeps, or that has none, is not.
    pollfd waiting{file, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(pipePatience.count()));
    if (ready == 0)
      return failure("file.io",
                     "this pipe is empty; start the program that writes to it first, or name a file",
                     {path.string(), 0, 0});
    const ssize_t bytes = ready < 0 ? -1 : ::read(file, buffer, sizeof buffer);
    if (bytes < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (bytes < 0) return systemFailure("read", path);
    if (bytes == 0) return contents;
    contents.append(buffer, static_cast<std::size_t>(bytes));
    if (contents.size() > maxBytes) {
      return failure("file.too-large", "the file is larger than " + std::to_string(maxBytes) + " bytes",
                     {path.string(), 0, 0});
    }
  }
}

}  // namespace

Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view contents) {
  std::error_code ignored;
  const std::filesystem::path target = linkTarget(path);
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path(), ignored);
  std::string temporary = target.string() + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) return systemFailure("create a temporary file beside it", path);
  const UnfinishedFile unfinished(temporary);
  const bool written = writeAll(file, contents) && ::fchmod(file, 0644) == 0 && ::fsync(file) == 0;
  const int writeError = errno;
  ::close(file);
  if (written && ::rename(temporary.c_str(), target.c_str()) == 0) return {};
  if (!written) errno = writeError;
  const auto result = systemFailure("write", path);
  ::unlink(temporary.c_str());
  return result;
}

Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes,
                             std::chrono::milliseconds pipePatience) {
  errno = 0;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return failure("file.directory", "this is a directory; name a file in it", {path.string(), 0, 0});
  }
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return systemFailure("open", path);
  auto contents = readAll(file, path, maxBytes, pipePatience);
  ::close(file);
  return contents;
}

}  // namespace robotlink
