// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <shared_mutex>

namespace robotlink {

/// Marks a file or folder that must not outlive the program in its present state, for example one that is
/// being written under a temporary name. The owner removes or renames it before this object is destroyed. If
/// a signal ends the program first, endProgram() removes it. The file need not exist yet. Any thread.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::filesystem::path path);
  ~UnfinishedFile();
  UnfinishedFile(UnfinishedFile&& other) noexcept;
  UnfinishedFile& operator=(UnfinishedFile&&) = delete;

 private:
  /// Empty if moved from.
  std::filesystem::path path_;
};

/// While an object of this class exists, endProgram() waits: for short changes of a file that people already
/// have, which would be damaged if the program ended in the middle. Any thread; objects in several threads do
/// not wait for each other.
class ChangeInPlace {
 public:
  ChangeInPlace();

 private:
  std::shared_lock<std::shared_mutex> lock_;
};

/// Waits for changes in place, removes all unfinished files and ends the program at once, without
/// destructors. Any thread, but not a signal handler: it locks mutexes.
[[noreturn]] void endProgram(int status);

}  // namespace robotlink
