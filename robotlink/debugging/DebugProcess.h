// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/BoundedQueue.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class DebugQueue;
class RemoteMotion;
class Request;
class RequestQueue;
}  // namespace robotcontrol

namespace robotlink {

/// The process of a layout that is linked to all others: collects their debug queues and hands requests out to them. Offers the
/// package "remote/motion". What it collects goes to its listener as whole queues, unchanged, in the process's thread; the
/// listener (a session, a network link) must not block.
class DebugProcess final : public Process {
 public:
  using Listener = std::function<void(std::shared_ptr<const robotcontrol::DebugQueue>)>;

  DebugProcess(std::string name, const Clock& clock, const std::vector<std::string>& processes);
  ~DebugProcess() override;

  /// Before it runs.
  void setListener(Listener listener);
  /// Hands a request in; any thread. False: too many wait, this one was dropped.
  bool request(const robotcontrol::Request& request);

 protected:
  void execute() override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
