// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/ProcessTable.h"

#include "robotlink/process/Process.h"

namespace robotlink {

void describe(const Process& process, robotcontrol::ProcessTable::Process& to) {
  to.set_name(process.name());
  const std::string failure = process.failure();
  to.set_state(!failure.empty() ? "failed: " + failure : process.stopped() ? "stopped" : "running");
  to.set_frames(process.frames());
  to.set_period(seconds(process.period()));
  to.set_priority(process.priority());
  for (const AnyReceiver* receiver : process.receivers()) {
    auto& port = *to.add_receivers();
    port.set_package(receiver->package());
    port.set_type(receiver->typeName());
    port.set_blocking(receiver->blocking());
    port.set_count(receiver->taken());
    port.set_missed(receiver->missed());
    port.set_peer(receiver->peer());
    port.set_held(receiver->held());
  }
  for (const AnySender* sender : process.senders()) {
    auto& port = *to.add_senders();
    port.set_package(sender->package());
    port.set_type(sender->typeName());
    port.set_blocking(sender->blocking());
    port.set_count(sender->sent());
    port.set_held(sender->held());
  }
}

}  // namespace robotlink
