// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/process/Process.h"

namespace robotlink {

/// The debug process's two links to one process: debug queues come in, requests go out. A newer package may
/// replace an older one on a link, so queues are acknowledged and requests are repeated until they are done.
/// Used by the debug process's thread; internal to this folder.
class ProcessChannel {
 public:
  ProcessChannel(Process& debugProcess, const std::string& process)
      : process_(process),
        queue_(debugProcess, "debug/queue/" + process, Blocking::kNo),
        requests_(debugProcess, "debug/requests/" + process, Blocking::kNo) {}

  const std::string& process() const { return process_; }
  /// The queue that arrived for this frame; null if none did. Removes the requests that it confirms.
  std::shared_ptr<const SharedDebugQueue> takeQueue();
  /// Enqueues a request; send() sends it.
  void add(const robotcontrol::Request& request) { pending_.push_back(request); }
  /// Removes and returns the requests that were never done.
  std::vector<robotcontrol::Request> takePending();
  /// Whether the process can be reached, which is always so inside a program.
  bool connected() const { return queue_.connected() && requests_.connected(); }
  /// Grows when the process was started again in another program.
  std::uint64_t generation() const { return queue_.generation(); }
  /// Call this then: all that is pending is sent again, and every queue is acknowledged.
  void restart();
  /// Sends pending requests and acknowledgments, if anything is new.
  void send();

 private:
  /// Removes the requests that a queue confirms.
  void confirm(const SharedDebugQueue& queue);

  std::string process_;
  Receiver<robotcontrol::DebugQueue> queue_;
  Sender<robotcontrol::RequestQueue> requests_;
  /// The requests that the process has not confirmed yet.
  std::deque<robotcontrol::Request> pending_;
  /// Number of the last confirmed request; requests count from 1.
  std::uint64_t done_ = 0;
  /// Number of the last request sent.
  std::uint64_t sent_ = 0;
  /// Number of the last queue received.
  std::uint64_t taken_ = 0;
  /// Number of the last queue acknowledged.
  std::uint64_t acknowledged_ = 0;
};

}  // namespace robotlink
