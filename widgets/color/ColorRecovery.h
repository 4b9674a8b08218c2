// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "colortool/SampleFile.h"

class QLockFile;

namespace widgets {

/// Keeps samples that are not yet saved in a file, so that they come back after the program or the computer
/// failed. Writes in a thread of its own. Several programs at a time keep theirs in files of their own
/// ("recovery.samples", "recovery-2.samples", ...), which are theirs as long as they hold a lock.
///
/// One thread calls it. The destructor waits until all that was asked for is done.
class ColorRecovery {
 public:
  /// `failed` is called in the thread, with why samples could not be kept.
  ColorRecovery(std::filesystem::path folder, std::function<void(robotlink::Error)> failed);
  ~ColorRecovery();
  ColorRecovery(const ColorRecovery&) = delete;
  ColorRecovery& operator=(const ColorRecovery&) = delete;

  /// What a program that ended badly left behind; nothing if none did. It stays in the file until keep() or
  /// drop(); a file that cannot be read whole is set aside under another name, which the errors tell.
  std::optional<robotlink::Result<colortool::ReadSamples>> left();
  /// Writes the samples; only the newest count.
  void keep(colortool::Samples samples);
  /// There is nothing to keep: removes the file.
  void drop();
  /// Waits until all that was asked for is done.
  void finish();

  const std::filesystem::path& file() const { return file_; }

 private:
  struct Job {
    std::optional<colortool::Samples> samples;  ///< none: the file goes
  };
  void choosePlace(const std::filesystem::path& folder);
  void ask(Job job);
  void run();
  void work(const Job& job) const;

  const std::function<void(robotlink::Error)> failed_;
  std::filesystem::path file_;
  std::unique_ptr<QLockFile> lock_;
  std::mutex mutex_;  // protects what follows but the thread
  std::condition_variable wakeUp_, done_;
  std::optional<Job> job_;
  bool busy_ = false;
  bool quit_ = false;
  std::thread thread_;
};

}  // namespace widgets
