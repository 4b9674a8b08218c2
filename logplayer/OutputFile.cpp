// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/OutputFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <system_error>

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;

tl::unexpected<robotlink::Error> existsAlready(const fs::path& file) {
  return robotlink::failure(
      "file.exists", "there is such a file already; name another one, or have it overwritten (--force)",
      {file.string(), 0, 0});
}

tl::unexpected<robotlink::Error> ioFailure(const std::string& action, const fs::path& file,
                                           const std::string& reason) {
  return robotlink::failure("file.io", "cannot " + action + ": " + reason, {file.string(), 0, 0}, {reason});
}

// Renames without overwriting. Not every file system can; there a link does the same in two steps.
int renameToNew(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  if (::link(from.c_str(), to.c_str()) != 0) return errno;
  ::unlink(from.c_str());
  return 0;
}

}  // namespace

Result<OutputFile> OutputFile::create(const fs::path& file, bool overwrite) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    return robotlink::failure("file.directory", "this is a directory; name a file in it",
                              {file.string(), 0, 0});
  }
  if (!overwrite && fs::exists(file, error)) return existsAlready(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return ioFailure("write", file, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK) != 0) return ioFailure("write", file, std::strerror(errno));
  OutputFile result;
  result.file_ = file;
  result.overwrite_ = overwrite;
  std::random_device random;
  do {
    result.temporary_ = folder / ("." + file.filename().string() + "." + std::to_string(random()) + ".part");
  } while (fs::exists(result.temporary_, error));
  return result;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : file_(std::move(other.file_)), temporary_(std::move(other.temporary_)), overwrite_(other.overwrite_) {
  other.temporary_.clear();
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<void> OutputFile::commit() {
  int error = 0;
  if (overwrite_) {
    if (::rename(temporary_.c_str(), file_.c_str()) != 0) error = errno;
  } else {
    error = renameToNew(temporary_, file_);
  }
  if (error == EEXIST) return existsAlready(file_);
  if (error != 0) return ioFailure("give the new file its name", file_, std::strerror(error));
  temporary_.clear();
  return {};
}

}  // namespace logplayer
