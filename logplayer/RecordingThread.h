// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "logplayer/FrameQueue.h"
#include "logplayer/RecordingFile.h"

namespace logplayer {

/// Writes frames into one file after the other, in the order in which frames and files came; nobody who
/// pushes waits for the disk. Frames that come while no file is open, or after one has failed, are let go.
///
/// All functions from any thread; the callbacks come from its own.
class RecordingThread {
 public:
  using Held = std::vector<robotlink::StreamMessage>;
  struct Options {
    std::size_t queueBytes = 64U << 20U;
    /// A file failed: it is closed, and what was written before can be read. `newest`: none was opened after
    /// it.
    std::function<void(const robotlink::Error&, bool newest)> failed;
    std::function<void(const std::string&)> warn;
  };
  /// How far the newest file is.
  struct Progress {
    std::filesystem::path path;
    std::uint64_t messages = 0;  ///< written
    std::uint64_t bytes = 0;     ///< of the file
    std::size_t queuedBytes = 0;
    DroppedMessages dropped;
  };

  explicit RecordingThread(Options options);
  ~RecordingThread();  ///< after all is done
  RecordingThread(const RecordingThread&) = delete;
  RecordingThread& operator=(const RecordingThread&) = delete;

  /// What is pushed from now on goes into this file, behind what held before.
  void open(std::shared_ptr<RecordingFile> file, Held before);
  /// The same with a file that is yet to be made, named after the one before; the same one if nothing is in
  /// it.
  void openNext(const RecordingFile::Options& how, Held before);
  void push(RecordedFramePtr frame);
  void close();

  Progress progress() const;
  void waitForRoom();
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void pushJob(FrameQueue::Job job);
  void run();
  std::vector<FrameQueue::Entry> takeSome();
  void write(const RecordedFrame& frame);
  void begin(std::shared_ptr<RecordingFile> file, Held before);
  void end();
  void tick();
  void fail(const robotlink::Error& error);
  void warnOfDropped();

  const Options options_;
  mutable std::mutex mutex_;  // protects the following
  std::condition_variable work_;
  std::condition_variable done_;
  FrameQueue queue_;
  DroppedMessages droppedBefore_;  // the newest file
  Progress progress_;
  bool busy_ = false;
  bool hurry_ = false;  // somebody waits for it
  bool quit_ = false;

  // Its own.
  std::shared_ptr<RecordingFile> file_;
  std::filesystem::path path_;    // of the newest file
  std::filesystem::path wished_;  // of the one that was opened; those where it went on are named after it
  Clock::time_point tickedAt_, warnedAt_;
  std::uint64_t warnedOf_ = 0;

  std::thread thread_;  // last: it uses the others
};

}  // namespace logplayer
