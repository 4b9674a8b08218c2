// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/UnfinishedFile.h"

#include <unistd.h>

#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace robotlink {
namespace {

/// The list is global because a signal ends the whole program.
struct UnfinishedFiles {
  std::mutex mutex;  // protects `paths`
  std::multiset<std::filesystem::path> paths;
  std::shared_mutex changes;  // shared by the changes in place

  /// Never destroyed: endProgram() may run while other statics are being destroyed.
  static UnfinishedFiles& all() {
    static auto* const files = new UnfinishedFiles;
    return *files;
  }
};

}  // namespace

UnfinishedFile::UnfinishedFile(std::filesystem::path path) : path_(std::move(path)) {
  UnfinishedFiles& files = UnfinishedFiles::all();
  const std::lock_guard lock(files.mutex);
  files.paths.insert(path_);
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}

UnfinishedFile::~UnfinishedFile() {
  if (path_.empty()) return;
  UnfinishedFiles& files = UnfinishedFiles::all();
  const std::lock_guard lock(files.mutex);
  files.paths.erase(files.paths.find(path_));
}

ChangeInPlace::ChangeInPlace() : lock_(UnfinishedFiles::all().changes) {}

void endProgram(int status) {
  UnfinishedFiles& files = UnfinishedFiles::all();
  // Never unlocked: no file may be changed or begun while the program ends.
  files.changes.lock();
  files.mutex.lock();
  std::error_code ignored;
  for (const auto& path : files.paths) std::filesystem::remove_all(path, ignored);
  ::_exit(status);
}

}  // namespace robotlink
