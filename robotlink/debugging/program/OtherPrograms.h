// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/process/Process.h"

namespace robotlink {

class ProcessChannel;

/// Tracks the programs that run the other processes of a layout, for the debug process: whether they
/// run and their processes return, and what they were asked for, which a program gets again when it was
/// started again. Used by the debug process; internal to this folder.
class OtherPrograms {
 public:
  explicit OtherPrograms(Process& debugProcess) : debugProcess_(debugProcess) {}

  /// The requests to each process whenever its program begins, by its name.
  using Questions = std::map<std::string, std::vector<robotcontrol::Request>>;
  /// Adds a program with the channels to its processes, which must outlive this object. `commanding` are
  /// those processes that decide what the platform does. Before the debug process runs.
  void add(const std::string& program, std::vector<ProcessChannel*> channels, Questions questions,
           const std::set<std::string>& commanding);
  /// Looks who came and went since the last call. Returns a sentence for each program that did.
  std::vector<std::string> update();

  /// The name of a process that decides what the platform does and cannot be reached, or does not return, so
  /// that the robot has to stand; empty if there is none. Any thread.
  std::string missingProcess() const;
  /// Whether a process belongs to one of them.
  bool runs(const std::string& process) const;
  /// Why a process can do nothing now, as "program vision, which runs process ball, does not run"; empty if
  /// it can, or if it runs in this program.
  std::string whyNot(const std::string& process) const;
  /// Remembers a request to a process: its program gets it again when it was started again. Returns whether
  /// the process runs in another program.
  bool remember(const std::string& process, const robotcontrol::Request& request);
  /// Remembers a request to all processes of all other programs.
  void rememberForAll(const robotcontrol::Request& request);
  /// Adds what the processes of the other programs do.
  void fillProcesses(robotcontrol::ProcessTable& to) const;

 private:
  /// A process of another program.
  struct Seat {
    ProcessChannel* channel = nullptr;
    /// The generation of its link when it was asked for everything.
    std::uint64_t generation = 0;
    std::vector<robotcontrol::Request> questions = {};
    bool isCommanding = false;
    std::vector<robotcontrol::Request> remembered = {};
    /// Whether its program reports that it does not return.
    std::atomic<bool> isStuck{false};
  };
  struct Program {
    std::string name;
    std::unique_ptr<Receiver<robotcontrol::ProcessTable>> table;
    std::deque<Seat> seats;
    bool running = false;
    bool ranBefore = false;
    std::uint64_t generation = 0;
  };
  static bool isConnected(const Program& program);
  static bool isCommanding(const Program& program);
  void askAgain(Seat& seat);
  /// Looks whether a process returns. Returns a sentence if that has changed.
  static std::string followStuck(const Program& program, Seat& seat);
  static const robotcontrol::ProcessTable::Process* rowOf(const Program& program, const std::string& process);
  static const Seat* seatOf(const Program& program, const std::string& process);
  /// "running", "stopped", "failed: ...", while its program runs.
  static std::string stateOf(const Program& program, const std::string& process);

  Process& debugProcess_;
  std::deque<Program> programs_;
  std::uint64_t repeated_ = 0;  // requests
};

}  // namespace robotlink
