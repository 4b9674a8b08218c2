// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "logplayer/record/FrameRing.h"
#include "logplayer/record/RecordingFile.h"
#include "robotlink/base/Worker.h"

namespace logplayer {

/// Writes snapshots of a FrameRing into files, one at a time, in a worker thread of its own, so that a
/// recording is not delayed. All functions may be called from any thread.
class RingSaver {
 public:
  /// The contents to save, and the file.
  struct Job {
    /// Null: a new file in `folder`, named after the time.
    std::shared_ptr<RecordingFile> file;
    std::filesystem::path folder;
    /// Format of a new file.
    RecordingFile::Options how;
    FrameRing::Contents contents;
  };
  /// Called in the worker thread with the path of the file, or the error.
  using Done = std::function<void(const robotlink::Result<std::filesystem::path>&)>;

  /// The destructor waits until the current job is done.
  explicit RingSaver(Done done);

  /// Starts a job; returns false without any effect if another one is running.
  bool start(Job job) { return worker_.postIfFree(std::move(job)); }
  /// Blocks until no job is running.
  void finish() { worker_.finish(); }

 private:
  /// Writes one file; called in the worker thread.
  static robotlink::Result<std::filesystem::path> save(Job job);

  robotlink::Worker<Job> worker_;
};

}  // namespace logplayer
