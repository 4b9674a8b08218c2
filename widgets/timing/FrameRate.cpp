// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/FrameRate.h"

namespace widgets {
namespace {

constexpr robotlink::Duration kRateOver = std::chrono::seconds(2);

}  // namespace

void FrameRate::add(robotlink::Instant time, std::uint64_t number) {
  if (number == 0) number = recent_.empty() ? 1 : recent_.back().number + 1;
  if (!recent_.empty() && (time < recent_.back().time || number <= recent_.back().number)) recent_.clear();
  recent_.push_back({time, number});
  while (recent_.size() > 2 && recent_[1].time <= time - kRateOver) recent_.pop_front();
}

double FrameRate::hertz() const {
  if (recent_.size() < 2) return 0;
  const double elapsed = robotlink::seconds(recent_.back().time - recent_.front().time);
  return elapsed > 0 ? static_cast<double>(recent_.back().number - recent_.front().number) / elapsed : 0;
}

double FrameRate::period(double ofProcess) const {
  if (ofProcess > 0) return ofProcess;
  const double rate = hertz();
  return rate > 0 ? 1 / rate : 0;
}

}  // namespace widgets
