// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ProcessChannel.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace robotlink {

std::shared_ptr<const SharedDebugQueue> ProcessChannel::takeQueue() {
  if (!queue_.isNew()) return nullptr;
  auto queue = queueIn(queue_.value());
  taken_ = queue->number;
  for (; done_ < queue->requestsDone && !pending_.empty(); ++done_) pending_.pop_front();
  return queue;
}

std::vector<robotcontrol::Request> ProcessChannel::takePending() {
  done_ += pending_.size();
  sent_ = std::max(sent_, done_);
  std::vector<robotcontrol::Request> result(pending_.begin(), pending_.end());
  pending_.clear();
  return result;
}

void ProcessChannel::restart() {
  sent_ = 0;
  acknowledged_ = 0;
  taken_ = std::numeric_limits<std::uint64_t>::max();
}

void ProcessChannel::send() {
  const std::uint64_t newest = done_ + pending_.size();
  if (newest == sent_ && taken_ == acknowledged_) return;
  auto package = std::make_shared<robotcontrol::RequestQueue>();
  package->set_first_number(done_ + 1);
  package->set_queues_taken(taken_);
  for (const robotcontrol::Request& request : pending_) *package->add_requests() = request;
  requests_.send(std::move(package));
  sent_ = newest;
  acknowledged_ = taken_;
}

}  // namespace robotlink
