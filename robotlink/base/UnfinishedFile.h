// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace robotlink {

/// Says that a file or folder must not outlive the program as it is: it is being written under a temporary
/// name, say. The owner removes or renames it before this is destroyed. Only if a signal ends the program
/// does endProgram() remove it instead. The file need not exist yet. Any thread.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::filesystem::path path);
  ~UnfinishedFile();
  UnfinishedFile(UnfinishedFile&& other) noexcept;
  UnfinishedFile& operator=(UnfinishedFile&&) = delete;

 private:
  std::filesystem::path path_;  // empty: moved away
};

/// Removes all unfinished files and ends the program at once, without destructors. Any thread, but not a
/// signal handler.
[[noreturn]] void endProgram(int status);

}  // namespace robotlink
