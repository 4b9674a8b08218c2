// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Sender.h"

#include <algorithm>

#include "robotlink/process/InProcessLink.h"
#include "robotlink/process/Process.h"

namespace robotlink {

AnySender::AnySender(Process& process, std::string package, Blocking blocking)
    : process_(process), package_(std::move(package)), blocking_(blocking) {
  process.add(*this);
}

void AnySender::send(const PackagePtr& package) {
  sent_.fetch_add(1, std::memory_order_relaxed);
  for (const Tap& tap : taps_) tap(package);
  for (const auto& link : links_) link->offer(package);
}

bool AnySender::delivered() const {
  return std::all_of(links_.begin(), links_.end(), [](const auto& link) { return link->delivered(); });
}

void AnySender::close() {
  for (const auto& link : links_) link->close();
}

void connectUnchecked(AnySender& sender, AnyReceiver& receiver) {
  auto link = std::make_shared<InProcessLink>(sender.process(), receiver.process());
  sender.connect(link);
  receiver.connect(std::move(link), sender.process().name());
}

}  // namespace robotlink
