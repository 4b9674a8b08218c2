// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/process/Process.h"

namespace robotlink {

/// The debug process's two links to one process: its debug queues in, requests out. Packages may replace each
/// other on their way, so queues are acknowledged, and requests are repeated until they are done. Used by the
/// debug process's thread; only for this folder.
class ProcessChannel {
 public:
  ProcessChannel(Process& debugProcess, const std::string& process)
      : process_(process),
        queue_(debugProcess, "debug/queue/" + process, Blocking::kNo),
        requests_(debugProcess, "debug/requests/" + process, Blocking::kNo) {}

  const std::string& process() const { return process_; }
  /// What came for this frame; null if nothing did.
  std::shared_ptr<const robotcontrol::DebugQueue> takeQueue();
  void add(const robotcontrol::Request& request) { pending_.push_back(request); }
  /// What was never done.
  std::vector<robotcontrol::Request> takePending();
  /// Sends requests and acknowledgements if there are new ones.
  void send();

 private:
  std::string process_;
  Receiver<robotcontrol::DebugQueue> queue_;
  Sender<robotcontrol::RequestQueue> requests_;
  std::deque<robotcontrol::Request> pending_;  // not yet done
  std::uint64_t done_ = 0;                     // the number of the last request that is
  std::uint64_t sent_ = 0;                     // the number of the last request that was sent
  std::uint64_t taken_ = 0;                    // the number of the last queue
  std::uint64_t acknowledged_ = 0;
};

}  // namespace robotlink
