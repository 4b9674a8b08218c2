// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RingSaver.h"

#include <utility>

namespace logplayer {

using robotlink::Result;

RingSaver::RingSaver(Done done) : done_(std::move(done)), thread_([this] { run(); }) {}

RingSaver::~RingSaver() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool RingSaver::start(Job job) {
  const std::lock_guard lock(mutex_);
  if (busy_) return false;
  busy_ = true;
  waiting_ = std::move(job);
  changed_.notify_all();
  return true;
}

void RingSaver::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_; });
}

void RingSaver::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return quit_ || waiting_; });
    if (!waiting_) return;
    Job job = std::move(*waiting_);
    waiting_.reset();
    lock.unlock();
    done_(save(std::move(job)));
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

Result<std::filesystem::path> RingSaver::save(Job job) {
  if (!job.file) {
    const auto path = newRecordingPath({}, job.folder);
    if (!path) return path;
    auto file = RecordingFile::create(*path, job.how);
    if (!file) return tl::unexpected(file.error());
    job.file = std::move(*file);
  }
  job.file->beginWith(std::move(job.contents.held));
  for (const RecordedFramePtr& frame : job.contents.frames) {
    if (const auto written = job.file->write(*frame); !written) return tl::unexpected(written.error());
  }
  if (const auto closed = job.file->close({}); !closed) return tl::unexpected(closed.error());
  return job.file->path();
}

}  // namespace logplayer
