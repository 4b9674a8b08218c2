// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogJob.h"

namespace widgets {

LogJob::LogJob(QString title, Work work)
    : title_(std::move(title)), worker_([this](const Work& operation, const std::stop_token& stop) {
        Outcome outcome = operation([&](double share) {
          share_ = share;
          return !stop.stop_requested();
        });
        outcome.canceled = stop.stop_requested() && !outcome.done;
        worker_.publish(std::move(outcome));
      }) {
  worker_.post(std::move(work));
}

}  // namespace widgets
