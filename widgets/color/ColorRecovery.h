// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "colortool/samples/SampleFile.h"
#include "robotlink/base/Worker.h"

class QLockFile;

namespace widgets {

/// Keeps unsaved samples in a recovery file, so that they can be restored after a crash of the program or the
/// computer. Files are written in a thread of its own. Several programs that run at the same time have
/// separate files ("recovery.samples", "recovery-2.samples", ...), each guarded by a lock file.
///
/// Called by one thread. The destructor waits until all jobs are done.
class ColorRecovery {
 public:
  /// Chooses a file in `folder` that no other program has locked, preferably one that was left behind.
  /// `failed` is called in the thread with why samples could not be written.
  ColorRecovery(std::filesystem::path folder, std::function<void(robotlink::Error)> failed);
  ~ColorRecovery();
  ColorRecovery(const ColorRecovery&) = delete;
  ColorRecovery& operator=(const ColorRecovery&) = delete;

  /// The samples that a crashed program left behind; unset if there are none. They stay in the file until
  /// keep() or drop(). A file that cannot be read whole is renamed, which the errors say.
  std::optional<robotlink::Result<colortool::ReadSamples>> left();
  /// Writes the samples to the file; replaces a job that has not begun.
  void keep(colortool::Samples samples) { worker_.post(std::move(samples)); }
  /// Deletes the file.
  void drop() { worker_.post(std::nullopt); }
  /// Blocks until all jobs are done.
  void finish() { worker_.finish(); }

  const std::filesystem::path& file() const { return file_; }

 private:
  /// The samples to write; unset: delete the file.
  using Job = std::optional<colortool::Samples>;
  /// Whether a file could be locked: done, taken by another program, or impossible in its folder.
  enum class Locking { kDone, kTaken, kImpossible };
  /// Sets file_ and lock_.
  void choosePlace(const std::filesystem::path& folder);
  /// Tries to lock a file; if that is done, it is file_.
  Locking lock(const std::filesystem::path& place);
  /// Executes a job, in the thread.
  void work(const Job& job) const;

  const std::function<void(robotlink::Error)> failed_;
  std::filesystem::path file_;
  /// Null: no file could be locked; file_ is then a name that no other program uses.
  std::unique_ptr<QLockFile> lock_;
  robotlink::Worker<Job> worker_;
};

}  // namespace widgets
