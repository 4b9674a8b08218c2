// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "logplayer/FrameRing.h"
#include "logplayer/RecordingFile.h"

namespace logplayer {

/// Writes what a ring kept into a file, in a thread of its own, one at a time, so that a recording that goes
/// on meanwhile is not held up. All functions from any thread.
class RingSaver {
 public:
  struct Job {
    std::shared_ptr<RecordingFile> file;  ///< null: a new one in `folder`, named after the time
    std::filesystem::path folder;
    RecordingFile::Options how;
    FrameRing::Contents contents;
  };
  /// The file that was written; called in the saver's thread.
  using Done = std::function<void(const robotlink::Result<std::filesystem::path>&)>;

  explicit RingSaver(Done done);
  ~RingSaver();  ///< after what was begun is done
  RingSaver(const RingSaver&) = delete;
  RingSaver& operator=(const RingSaver&) = delete;

  /// False: the one before is still being written, and nothing happens.
  bool start(Job job);
  void finish();

 private:
  void run();
  static robotlink::Result<std::filesystem::path> save(Job job);

  const Done done_;
  std::mutex mutex_;  // protects the following
  std::condition_variable changed_;
  std::optional<Job> waiting_;
  bool busy_ = false;
  bool quit_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace logplayer
