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
  confirm(*queue);
  return queue;
}

/// A queue that was on its way while this process was started again still counts the requests of the one
/// before; its id tells.
void ProcessChannel::confirm(const SharedDebugQueue& queue) {
  if (queue.requestsDone <= done_ || queue.requestsDone - done_ > pending_.size()) return;
  const auto count = static_cast<std::ptrdiff_t>(queue.requestsDone - done_);
  if (pending_[static_cast<std::size_t>(count) - 1].id() != queue.requestDone) return;
  pending_.erase(pending_.begin(), pending_.begin() + count);
  done_ = queue.requestsDone;
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
