// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RecordingThread.h"

#include <utility>

namespace logplayer {
namespace {

constexpr std::chrono::milliseconds kTick{50};
/// Fewer bytes do not wake the thread; the next tick writes them. So it processes many frames at once, and
/// producers seldom have to wait for the mutex.
constexpr std::size_t kWorthWaking = 1U << 20U;
constexpr std::size_t kMaxAtOnce = 256;
constexpr std::chrono::seconds kWarnEvery{5};

}  // namespace

RecordingThread::RecordingThread(Options options)
    : options_(std::move(options)),
      queue_(options_.queueBytes),
      nextAt_(Clock::now() + kTick),
      thread_({.due = [this] { return due(); }, .step = [this] { step(); }, .end = [this] { writeRest(); }}) {
}

// ---- Input

void RecordingThread::pushJob(FrameQueue::Job job) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push(std::move(job));
    hurry_ = true;
  }
  thread_.wake();
}

void RecordingThread::push(RecordedFramePtr frame) {
  bool wakes = false;
  {
    const std::lock_guard lock(mutex_);
    queue_.push(std::move(frame));
    wakes = queue_.bytes() > kWorthWaking;
  }
  if (wakes) thread_.wake();
}

void RecordingThread::open(std::shared_ptr<RecordingFile> file, Held before) {
  DroppedMessages dropped;
  {
    const std::lock_guard lock(mutex_);
    progress_ = {};
    progress_.path = file->path();
    dropped = droppedBefore_ = queue_.dropped();
  }
  pushJob([this, file = std::move(file), before = std::move(before), dropped]() mutable {
    requested_ = file->path();
    begin(std::move(file), std::move(before), dropped);
  });
}

void RecordingThread::openNext(const RecordingFile::Options& how, Held before) {
  pushJob([this, how, before = std::move(before)]() mutable {
    if (!file_) return;  // the file has failed
    if (file_->messages() == 0) return file_->beginWith(std::move(before));
    end();
    auto made = RecordingFile::create(nextRecordingPath(requested_), how);
    if (!made) return fail(made.error());
    DroppedMessages dropped;
    {
      const std::lock_guard lock(mutex_);
      dropped = queue_.dropped();
      if (isNewest()) {
        progress_ = {};
        progress_.path = (*made)->path();
        droppedBefore_ = dropped;
      }
    }
    begin(std::move(*made), std::move(before), dropped);
  });
}

void RecordingThread::close() {
  pushJob([this] { end(); });
}

// ---- Worker thread

RecordingThread::Clock::time_point RecordingThread::due() {
  const std::lock_guard lock(mutex_);
  if (queue_.empty()) {
    hurry_ = false;
    done_.notify_all();
  }
  return hurry_ || queue_.bytes() > kWorthWaking ? Clock::time_point() : nextAt_;
}

void RecordingThread::step() {
  std::unique_lock lock(mutex_);
  std::vector<FrameQueue::Entry> entries = takeSome();
  busy_ = true;
  lock.unlock();
  for (const FrameQueue::Entry& entry : entries) {
    if (entry.frame) write(*entry.frame);
    if (entry.job) entry.job();
  }
  entries.clear();
  tick();
  lock.lock();
  busy_ = false;
  if (file_ && isNewest()) {
    progress_.messages = file_->messages();
    progress_.bytes = file_->bytes();
  }
  if (queue_.bytes() <= options_.queueBytes / 2) done_.notify_all();
  nextAt_ = Clock::now() + kTick;
}

void RecordingThread::writeRest() {
  const auto isEmpty = [this] {
    const std::lock_guard lock(mutex_);
    return queue_.empty();
  };
  while (!isEmpty()) step();
}

std::vector<FrameQueue::Entry> RecordingThread::takeSome() {
  std::vector<FrameQueue::Entry> entries;
  std::size_t bytes = 0;
  while (entries.size() < kMaxAtOnce && bytes < kWorthWaking) {
    auto entry = queue_.pop();
    if (!entry) break;
    bytes += entry->frame ? entry->frame->bytes : 0;
    entries.push_back(std::move(*entry));
  }
  return entries;
}

void RecordingThread::begin(std::shared_ptr<RecordingFile> file, Held before,
                            const DroppedMessages& droppedSoFar) {
  path_ = file->path();
  file_ = std::move(file);
  droppedBeforeFile_ = droppedSoFar;
  file_->beginWith(std::move(before));
}

void RecordingThread::write(const RecordedFrame& frame) {
  if (!file_) return;
  if (const auto written = file_->write(frame); !written) fail(written.error());
}

void RecordingThread::end() {
  const auto file = std::exchange(file_, nullptr);
  if (!file) return;
  DroppedMessages dropped;
  {
    const std::lock_guard lock(mutex_);
    dropped = queue_.dropped() - droppedBeforeFile_;
  }
  warnOfDropped();
  if (const auto closed = file->close(dropped); !closed) return fail(closed.error());
  const std::lock_guard lock(mutex_);
  if (progress_.path != file->path()) return;  // the next file is open already
  progress_.messages = file->messages();
  progress_.bytes = file->bytes();
}

void RecordingThread::fail(const robotlink::Error& error) {
  file_.reset();
  bool newest = false;
  {
    const std::lock_guard lock(mutex_);
    newest = isNewest();
  }
  if (options_.failed) options_.failed(error, newest);
}

void RecordingThread::tick() {
  const auto now = Clock::now();
  if (now - tickedAt_ < kTick) return;
  tickedAt_ = now;
  if (file_) {
    if (const auto ticked = file_->tick(); !ticked) fail(ticked.error());
  }
  if (now - warnedAt_ < kWarnEvery) return;
  warnedAt_ = now;
  warnOfDropped();
}

void RecordingThread::warnOfDropped() {
  if (!options_.warn) return;
  std::uint64_t dropped = 0;
  {
    const std::lock_guard lock(mutex_);
    dropped = queue_.dropped().messages;
  }
  if (dropped == warnedOf_) return;
  options_.warn("The disk does not keep up with the recording: " + std::to_string(dropped - warnedOf_) +
                " messages were dropped, the largest first; record fewer streams, or images as JPEG");
  warnedOf_ = dropped;
}

// ---- Status

RecordingThread::Progress RecordingThread::progress() const {
  const std::lock_guard lock(mutex_);
  Progress progress = progress_;
  progress.queuedBytes = queue_.bytes();
  progress.dropped = queue_.dropped() - droppedBefore_;
  return progress;
}

void RecordingThread::waitForRoom() {
  std::unique_lock lock(mutex_);
  if (queue_.bytes() <= options_.queueBytes / 2) return;
  hurry_ = true;
  thread_.wake();
  done_.wait(lock, [this] { return queue_.bytes() <= options_.queueBytes / 2; });
}

void RecordingThread::finish() {
  std::unique_lock lock(mutex_);
  hurry_ = true;
  thread_.wake();
  done_.wait(lock, [this] { return queue_.empty() && !busy_ && !hurry_; });
}

}  // namespace logplayer
