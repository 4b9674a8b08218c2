// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "logplayer/record/FrameQueue.h"
#include "logplayer/record/RecordingFile.h"
#include "robotlink/base/threads/PacedThread.h"

namespace logplayer {

/// The worker thread of a recorder. Writes frames into one file after the other, in the order of the calls;
/// callers never wait for the disk. Frames are discarded while no file is open, and after the file has
/// failed.
///
/// All functions may be called from any thread; callbacks run in the worker thread. It has a queue of its
/// own, since that is bounded by the bytes of the frames, and takes many of them at once.
class RecordingThread {
 public:
  /// Latched messages with which a file begins.
  using Held = std::vector<robotlink::StreamMessage>;
  /// Fixed settings of the thread.
  struct Options {
    std::size_t queueBytes = 64U << 20U;
    /// Called when a file has failed; it is closed, and what was written before remains readable. `newest`:
    /// no other file was opened after it.
    std::function<void(const robotlink::Error&, bool newest)> failed;
    /// Called with a message for the user when messages were dropped, about every five seconds at most.
    std::function<void(const std::string&)> warn;
  };
  /// How far the newest file is.
  struct Progress {
    std::filesystem::path path;
    /// Number of messages written.
    std::uint64_t messages = 0;
    /// Size of the file.
    std::uint64_t bytes = 0;
    /// Size of the frames in the queue.
    std::size_t queuedBytes = 0;
    /// Messages dropped since the file was opened.
    DroppedMessages dropped;
  };

  explicit RecordingThread(Options options);
  /// Waits until the queue is empty.
  ~RecordingThread() = default;
  RecordingThread(const RecordingThread&) = delete;
  RecordingThread& operator=(const RecordingThread&) = delete;

  /// Directs all following frames into this file, which begins with `before`.
  void open(std::shared_ptr<RecordingFile> file, Held before);
  /// The same with a new file named after the first one of this recording. If nothing has been written to the
  /// current file, that one is used.
  void openNext(const RecordingFile::Options& how, Held before);
  /// Enqueues a frame; this may drop frames, see FrameQueue.
  void push(RecordedFramePtr frame);
  /// Closes the file behind all frames pushed so far; returns immediately.
  void close();

  Progress progress() const;
  /// See Recorder::waitForRoom() and Recorder::finish().
  void waitForRoom();
  void finish();

 private:
  using Clock = robotlink::PacedThread::Clock;
  /// Enqueues a job and wakes the thread.
  void pushJob(FrameQueue::Job job);
  /// When entries are written next: at once, if there are many or if a caller waits. The functions that
  /// follow are called in the worker thread.
  Clock::time_point due();
  /// Writes a batch of entries.
  void step();
  /// Writes what is left in the queue.
  void writeRest();
  /// Removes a batch of entries from the queue; requires the mutex to be locked.
  std::vector<FrameQueue::Entry> takeSome();
  void write(const RecordedFrame& frame);
  /// `droppedSoFar`: the total before this file was opened.
  void begin(std::shared_ptr<RecordingFile> file, Held before, const DroppedMessages& droppedSoFar);
  void end();
  /// Whether no other file was opened after the one that is written; requires the mutex to be locked.
  bool isNewest() const { return progress_.path == path_; }
  /// Flushes old chunks and warns about dropped messages, each at its interval.
  void tick();
  /// Discards the file and reports the error.
  void fail(const robotlink::Error& error);
  void warnOfDropped();

  const Options options_;
  /// Protects all members from here to hurry_.
  mutable std::mutex mutex_;
  /// Notified when the queue is at most half full, and when it is empty.
  std::condition_variable done_;
  FrameQueue queue_;
  /// The total before the newest file was opened.
  DroppedMessages droppedBefore_;
  Progress progress_;
  /// Whether the worker thread is writing a batch.
  bool busy_ = false;
  /// Whether a caller waits, so that the thread must not wait for more frames.
  bool hurry_ = false;

  // The members from here on are used by the worker thread only.
  std::shared_ptr<RecordingFile> file_;
  /// The total before file_ was opened; a newer file may be waiting already.
  DroppedMessages droppedBeforeFile_;
  /// Path of the newest file.
  std::filesystem::path path_;
  /// Path of the file that was opened; continuations are named after it.
  std::filesystem::path requested_;
  /// When few entries are written, for which the thread is not woken.
  Clock::time_point nextAt_;
  Clock::time_point tickedAt_, warnedAt_;
  /// The total of dropped messages at the last warning.
  std::uint64_t warnedOf_ = 0;

  /// Declared last, since it uses all others.
  robotlink::PacedThread thread_;
};

}  // namespace logplayer
