// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class ColorTable;
class KeyTable;
class MotionTable;
class MotionText;
class ProcessTable;
class RemoteMotion;
class Request;
class SolutionTable;
}  // namespace robotcontrol

namespace robotlink {

class AnySender;
struct SharedDebugQueue;

/// The process of a layout that is linked to all others: it collects their debug queues and distributes
/// requests to them. It sends the packages "remote/motion", "remote/goal", "colors/table" and "motions/texts"
/// on behalf of the user. The queues go to its listener unchanged, as a whole, in the process's thread; the
/// listener (a session, a network link) must not block.
///
/// Each request is answered exactly once, by a RequestResult: by the process that owns the task or package,
/// or, for debug keys, motions, tables, and whatever cannot be delivered, by this process itself. It joins
/// the processes' tables of keys and solutions into one each, and tells twice a second what all processes do,
/// and which color table is in use, and which key-frame motions there are, whenever that changes.
/// A process that failed is reported as an error, once.
class DebugProcess final : public Process {
 public:
  /// Called with each debug queue, in this process's thread.
  using Listener = std::function<void(std::shared_ptr<const SharedDebugQueue>)>;

  DebugProcess(std::string name, const Clock& clock, const DebugRoutes& routes);
  ~DebugProcess() override;

  /// Call it before the process runs.
  void setListener(Listener listener);
  /// Adds a process of this program (itself, a task process, the platform) to the table of processes. It must
  /// outlive this object. Call it before the process runs.
  void watch(const Process& process);
  /// Says which of the processes run in another program, what each is asked for whenever that begins, and
  /// which ones decide what the platform does. The links to it are made by RobotProgram. Call it before the
  /// process runs.
  void addProgram(const std::string& program,
                  const std::map<std::string, std::vector<robotcontrol::Request>>& processes,
                  const std::set<std::string>& commanding);
  /// The name of a process of another program that decides what the platform does and cannot be reached;
  /// empty if there is none. Any thread.
  std::string missingProcess() const;
  /// Processes of other programs get a request, now and whenever their program was started again; the others
  /// do not. Call it before the process runs.
  void askOtherPrograms(const robotcontrol::Request& request);
  /// Adds a package that the platform produces only while it is received; this process receives it while its
  /// key is on. The sender must outlive this object. Call it before the process runs.
  void showOnRequest(AnySender& sender);
  /// Sends one of the packages that this process offers, so that it is there in the first frame. Other
  /// packages and invalid color tables are ignored. Call it before the process runs.
  void offer(const PackagePtr& package);
  /// Whether there is a handler for requests of this kind; those to task processes are passed on without one.
  static bool fulfills(const robotcontrol::Request& request);
  /// Enqueues a request; any thread. Returns false if the queue is full and the request was dropped.
  bool request(const robotcontrol::Request& request);

  // Previews. Only while no process of the program runs.
  /// The reason why this process would refuse a request or could not forward it; empty if it would not. The
  /// process that gets it may still refuse it.
  std::string refusal(const robotcontrol::Request& request) const;
  /// The process that a request would be forwarded to; empty if this one handles it.
  std::string processAsked(const robotcontrol::Request& request) const;
  /// Tables by process.
  using Tables = std::map<std::string, std::pair<robotcontrol::KeyTable, robotcontrol::SolutionTable>>;
  /// The tables of processes that have not reported theirs yet. Before it runs.
  void setTables(Tables ofProcesses);
  /// The tables of the whole program, merged from those of the other processes.
  void describe(const Tables& ofProcesses, robotcontrol::KeyTable& keys,
                robotcontrol::SolutionTable& solutions, robotcontrol::ProcessTable& processes) const;
  /// The last package of a platform that no task reads; null if there is none.
  PackagePtr newest(const std::string& package) const;
  /// The color table in use, without its cells (ColorTableInUse.h); none: no task of the program uses one.
  std::optional<robotcontrol::ColorTable> colorTableInUse() const;
  /// The key-frame motions, with `more` among them; none: no task of the program plays any.
  std::optional<robotcontrol::MotionTable> motions(const std::vector<robotcontrol::MotionText>& more) const;

 protected:
  void execute() override;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
