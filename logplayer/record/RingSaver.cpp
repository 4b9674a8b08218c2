// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/RingSaver.h"

#include <utility>

namespace logplayer {

using robotlink::Result;

RingSaver::RingSaver(Done done)
    : worker_([done = std::move(done)](Job job, const std::stop_token&) { done(save(std::move(job))); },
              {.finishesJobs = true}) {}

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
