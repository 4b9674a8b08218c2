// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"

class QLockFile;

namespace widgets {

/// A file that keeps an unsaved document, so that it can be restored after a crash of the program or the
/// computer. It is written in a thread of its own. Several programs that run at the same time have separate
/// files ("recovery.mof", "recovery-2.mof", ...), each guarded by a lock file.
///
/// Called by one thread. The destructor waits until all jobs are done.
class RecoveryFile {
 public:
  using Write = std::function<robotlink::Result<void>(const std::filesystem::path& file)>;

  /// Chooses a file in `folder`, with this suffix, that no other program has locked, preferably one that was
  /// left behind. `failed` is called in the thread with why the document could not be written.
  RecoveryFile(std::filesystem::path folder, std::string suffix,
               std::function<void(robotlink::Error)> failed);
  ~RecoveryFile();
  RecoveryFile(const RecoveryFile&) = delete;
  RecoveryFile& operator=(const RecoveryFile&) = delete;

  /// Whether a program that crashed left the file behind. It stays until keep() or drop().
  bool isLeft() const;
  /// Renames the file to the first free "NAME-damaged-N" in the same folder; returns its new path.
  std::filesystem::path setAside() const;
  /// Lets `write` write the file, in the thread; replaces a job that has not begun.
  void keep(Write write) { worker_.post(std::move(write)); }
  /// Deletes the file.
  void drop() { worker_.post(Write()); }
  /// Blocks until all jobs are done.
  void finish() { worker_.finish(); }

  const std::filesystem::path& file() const { return file_; }

 private:
  /// Whether a file could be locked: done, taken by another program, or impossible in its folder.
  enum class Locking { kDone, kTaken, kImpossible };
  /// Sets file_ and lock_.
  void choosePlace(const std::filesystem::path& folder);
  /// The file of a number, counted from 1.
  std::filesystem::path fileAt(const std::filesystem::path& folder, int number) const;
  /// Tries to lock a file; if that is done, it is file_.
  Locking lock(const std::filesystem::path& place);
  /// Executes a job, in the thread; an empty one deletes the file.
  void work(const Write& write) const;

  const std::string suffix_;
  const std::function<void(robotlink::Error)> failed_;
  std::filesystem::path file_;
  /// Null: no file could be locked; file_ is then a name that no other program uses.
  std::unique_ptr<QLockFile> lock_;
  robotlink::Worker<Write> worker_;
};

}  // namespace widgets
