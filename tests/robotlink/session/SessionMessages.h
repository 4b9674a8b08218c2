// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/StreamMessage.h"

// Messages from robots for tests of sessions.
namespace robotlink::test {

inline Instant at(double time) {
  return Instant(fromSeconds(time));
}

inline robotcontrol::DebugMessage& add(robotcontrol::DebugQueue& queue, const std::string& path,
                                       double time) {
  robotcontrol::DebugMessage& message = *queue.add_messages();
  message.set_path(path);
  assign(*message.mutable_timestamp(), at(time));
  return message;
}

inline void endFrame(robotcontrol::DebugQueue& queue, double time, std::uint64_t number) {
  auto& frame = *add(queue, "frames/" + queue.process(), time).mutable_frame();
  frame.set_process(queue.process());
  frame.set_number(number);
}

inline std::shared_ptr<robotcontrol::DebugQueue> queueOf(const std::string& process) {
  auto queue = std::make_shared<robotcontrol::DebugQueue>();
  queue->set_process(process);
  return queue;
}

inline StreamMessage plot(const std::string& path, double time, std::size_t bytes = 0) {
  auto value = std::make_shared<robotcontrol::PlotValue>();
  value->set_unit(std::string(bytes, 'x'));
  return {path, at(time), value};
}

}  // namespace robotlink::test
