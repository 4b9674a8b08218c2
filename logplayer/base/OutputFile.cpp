// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/OutputFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include "logplayer/mcap/write/Sink.h"
#include "robotlink/base/LinkTarget.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;

tl::unexpected<robotlink::Error> existsAlready(const fs::path& file) {
  return robotlink::failure("file.exists",
                            "this file already exists; choose another name, or overwrite it (--force)",
                            {file.string(), 0, 0});
}

tl::unexpected<robotlink::Error> ioFailure(const std::string& action, const fs::path& file,
                                           const std::string& reason) {
  return robotlink::failure("file.io", "cannot " + action + ": " + reason, {file.string(), 0, 0}, {reason});
}

// Renames without overwriting. On file systems that do not support this, a hard link does the same in two
// steps.
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
  const fs::path target = overwrite ? robotlink::linkTarget(file) : file;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return ioFailure("write", file, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK) != 0) return ioFailure("write", file, std::strerror(errno));
  OutputFile result;
  result.given_ = file;
  result.file_ = target;
  result.overwrite_ = overwrite;
  std::random_device random;
  do {
    result.temporary_ =
        folder / ("." + target.filename().string() + "." + std::to_string(random()) + ".part");
  } while (fs::exists(result.temporary_, error));
  result.unfinished_.emplace(result.temporary_);
  return result;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : given_(std::move(other.given_)),
      file_(std::move(other.file_)),
      temporary_(std::exchange(other.temporary_, {})),
      overwrite_(other.overwrite_),
      unfinished_(std::move(other.unfinished_)) {}

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
  if (error == EEXIST) return existsAlready(given_);
  if (error != 0) return ioFailure("give the new file its name", given_, std::strerror(error));
  temporary_.clear();
  unfinished_.reset();
  return {};
}

robotlink::Error OutputFile::named(robotlink::Error error) const {
  if (error.where.file != temporary_.string()) return error;
  error.where.file = given_.string();
  const auto kept = error.text.find(mcap::kWhatIsKept);
  if (kept != std::string::npos) error.text.replace(kept, std::strlen(mcap::kWhatIsKept), "; it was deleted");
  return error;
}

}  // namespace logplayer
