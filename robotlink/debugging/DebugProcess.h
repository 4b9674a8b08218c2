// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class DebugQueue;
class RemoteMotion;
class Request;
}  // namespace robotcontrol

namespace robotlink {

class AnySender;

/// The process of a layout that is linked to all others: collects their debug queues and hands requests out
/// to them. Offers the packages "remote/motion", "remote/goal" and "colors/table". What it collects goes to its listener as
/// whole queues, unchanged, in the process's thread; the listener (a session, a network link) must not block.
///
/// Each request is answered exactly once, by a RequestResult: by the process that owns the task or package,
/// or, for debug keys, motions, tables, and whatever cannot be delivered, by this process itself. It joins
/// the processes' tables of keys and solutions into one each, and tells twice a second what all processes do.
/// A process that failed is told as an error, once.
class DebugProcess final : public Process {
 public:
  using Listener = std::function<void(std::shared_ptr<const robotcontrol::DebugQueue>)>;

  DebugProcess(std::string name, const Clock& clock, const DebugRoutes& routes);
  ~DebugProcess() override;

  /// Before it runs.
  void setListener(Listener listener);
  /// A process for the table, in this program: itself, a task process, the platform. It must outlive this
  /// one. Before it runs.
  void watch(const Process& process);
  /// A package of the platform that is made only while somebody receives it: this process does while its key
  /// is on. The sender must outlive this. Before it runs.
  void showOnRequest(AnySender& sender);
  /// Before it runs: sends one of the packages that it offers, so that it is there in the first frame. Others
  /// are ignored.
  void offer(const PackagePtr& package);
  /// Hands a request in; any thread. False: too many wait, this one was dropped.
  bool request(const robotcontrol::Request& request);

 protected:
  void execute() override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
