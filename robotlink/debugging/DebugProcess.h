// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class ColorTable;
class DebugQueue;
class KeyTable;
class ProcessTable;
class RemoteMotion;
class Request;
class SolutionTable;
}  // namespace robotcontrol

namespace robotlink {

class AnySender;

/// The process of a layout that is linked to all others: collects their debug queues and hands requests out
/// to them. Offers the packages "remote/motion", "remote/goal" and "colors/table". What it collects goes to
/// its listener as whole queues, unchanged, in the process's thread; the listener (a session, a network link)
/// must not block.
///
/// Each request is answered exactly once, by a RequestResult: by the process that owns the task or package,
/// or, for debug keys, motions, tables, and whatever cannot be delivered, by this process itself. It joins
/// the processes' tables of keys and solutions into one each, and tells twice a second what all processes do,
/// and which color table is in use whenever that changes.
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

  // What it would say if it ran now. Only while no process of the program runs.
  /// Why it would not do what is asked, or not hand it on; empty if it would. Whoever it is handed to may
  /// refuse it still.
  std::string refusal(const robotcontrol::Request& request) const;
  /// The process that is asked; empty: this one.
  std::string processAsked(const robotcontrol::Request& request) const;
  /// The tables of the whole program, joined from those of its other processes: their names with their
  /// tables.
  using Tables = std::map<std::string, std::pair<robotcontrol::KeyTable, robotcontrol::SolutionTable>>;
  void describe(const Tables& ofProcesses, robotcontrol::KeyTable& keys,
                robotcontrol::SolutionTable& solutions, robotcontrol::ProcessTable& processes) const;
  /// Without its cells (ColorTableInUse.h); none: no task of the program uses one.
  std::optional<robotcontrol::ColorTable> colorTableInUse() const;

 protected:
  void execute() override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
