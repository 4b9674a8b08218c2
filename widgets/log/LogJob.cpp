// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogJob.h"

namespace widgets {

LogJob::LogJob(QString title, Work work) : title_(std::move(title)) {
  thread_ = std::thread([this, work = std::move(work)] {
    Outcome outcome = work([this](double share) {
      share_ = share;
      return !canceled_;
    });
    outcome.canceled = canceled_ && !outcome.done;
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
  });
}

LogJob::~LogJob() {
  cancel();
  thread_.join();
}

std::optional<LogJob::Outcome> LogJob::outcome() {
  const std::lock_guard lock(mutex_);
  return outcome_;
}

}  // namespace widgets
