// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "logplayer/record/FrameRing.h"
#include "logplayer/record/RecordingFile.h"

namespace logplayer {

/// Writes snapshots of a FrameRing into files, one at a time, in a worker thread of its own, so that a
/// recording is not delayed. All functions may be called from any thread.
class RingSaver {
 public:
  /// What is saved, and where.
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

  explicit RingSaver(Done done);
  /// Waits until the current job is done.
  ~RingSaver();
  RingSaver(const RingSaver&) = delete;
  RingSaver& operator=(const RingSaver&) = delete;

  /// Starts a job; returns false without any effect if another one is running.
  bool start(Job job);
  /// Blocks until no job is running.
  void finish();

 private:
  /// The loop of the worker thread.
  void run();
  /// Writes one file; called in the worker thread.
  static robotlink::Result<std::filesystem::path> save(Job job);

  const Done done_;
  /// Protects all members from here to quit_.
  std::mutex mutex_;
  std::condition_variable changed_;
  /// The job that the worker thread has not started yet.
  std::optional<Job> waiting_;
  /// Whether a job is waiting or running.
  bool busy_ = false;
  bool quit_ = false;
  /// Declared last, since it uses all others.
  std::thread thread_;
};

}  // namespace logplayer
