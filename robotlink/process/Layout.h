// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/process/TaskCatalog.h"

namespace robotlink {

/// A process layout as read from its file: which process runs which tasks, with which solution at the start.
/// A plain value; every part knows its position in the file for error messages. The format is described in
/// robotlink/process/LAYOUTS.md.
struct Layout {
  /// A task of a process.
  struct Task {
    std::string task;
    /// The solution at the start.
    std::string solution;
    FilePosition where;
    /// The solution in the file, if another one was chosen in its place; otherwise empty. Not in files.
    std::string ownSolution = {};

    /// Makes the task start with another solution than the file's.
    void choose(const std::string& chosen) {
      if (ownSolution.empty()) ownSolution = solution;
      solution = chosen;
    }
  };
  /// A package that a process waits for.
  struct Input {
    std::string package;
    FilePosition where;
    /// None of the process's tasks needs to read it; it only triggers the process.
    bool paceOnly = false;
  };
  /// A process of the robot program: a loop that runs its tasks in order.
  struct Process {
    std::string name;
    /// Nice value, -20 (most urgent) to 19.
    int priority = 0;
    /// Minimal time from frame to frame; 0 means event-driven.
    Duration period{0};
    /// The debug process: it collects all debug queues, distributes requests and has no tasks.
    bool debug = false;
    /// In the order of execution.
    std::vector<Task> tasks;
    /// No frame starts without a new one of each of these packages of other processes.
    std::vector<Input> blocking;
    /// No frame starts before all receivers have taken what its tasks sent of each of these packages.
    std::vector<Input> blockingOutputs = {};
    FilePosition where;
  };
  /// A program of the operating system that runs some of the processes (LAYOUTS.md).
  struct Program {
    /// A process that it runs.
    struct Part {
      std::string process;
      FilePosition where;
    };
    std::string name;
    /// The address of the machine that it runs on; empty: all programs run on one machine.
    std::string host;
    std::vector<Part> processes;
    FilePosition where;
  };
  /// A task that the layout has but that cannot run here; kept so that users can see why.
  struct Absence {
    std::string process;
    std::string task;
    /// A text such as "nobody offers joints/states".
    std::string reason;
  };
  std::string name;
  std::string help;
  std::string file;
  /// In lockstep they run in this order.
  std::vector<Process> processes;
  /// Empty: one program runs all processes.
  std::vector<Program> programs = {};
  /// Solutions that run in shadow mode from the start: on the same inputs, without being used.
  std::vector<Task> shadows = {};

  /// The program that runs a process; null if the layout names none.
  const Program* programOf(const std::string& process) const;
  const Program* findProgram(const std::string& program) const;
  /// The program with the debug process, which has the platform, too. Null if the layout names none.
  const Program* mainProgram() const;

  // Not in files: set when the layout is applied to a platform with fewer packages, such as a log.
  std::vector<Absence> absent;
  /// Packages that its tasks do not send to other processes, because another source offers them.
  std::set<std::string> withheld;
};

/// The packages available to a layout from outside: those that the platform offers and takes
/// (resources/robots/<robot>.yaml), and those that the debug process offers on behalf of the user
/// (remote/motion).
struct PlatformPackages {
  std::vector<std::string> offers;
  std::vector<std::string> takes;
  std::vector<std::string> debugOffers;
};

/// Reads a layout and checks only its form, not its tasks; reports every problem with its position.
tl::expected<Layout, Errors> readLayout(const std::filesystem::path& file);
/// Reads the text of a layout as readLayout() does; `file` is the name that errors carry.
tl::expected<Layout, Errors> parseLayout(const std::string& text, const std::string& file);

/// A link between two processes, derived from their inputs and outputs. An empty process name is the
/// platform.
struct LayoutLink {
  std::string package;
  std::string from;
  std::string to;
  /// The receiving process waits for the package.
  bool blocking = false;
  /// No solution requires the package.
  bool optional = false;
  bool operator==(const LayoutLink&) const = default;
};

/// Returns everything that makes a layout unusable, each with its position and what to do about it: an
/// unknown or repeated task, solution or name; a default solution that is unavailable; an input that nothing
/// produces; an output produced twice; a cycle inside a process; a cycle of blocking inputs between
/// processes; a process with neither a blocking input nor a period; a blocking input that no task of the
/// process uses; a blocking output that none yields; a process that is in no program or in two. Empty: the
/// layout can run. The ids are listed in LAYOUTS.md.
Errors checkLayout(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

/// The reason why a solution cannot run in a layout that checkLayout() accepted, "unavailable because nobody
/// offers oracle/world"; empty if it can run.
std::string unavailability(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform,
                           const std::string& task, const std::string& solution);

/// The links between processes, in the order of the layout. They cover all solutions of its tasks, not only
/// the chosen ones, so that a solution can be switched without relinking. Packages that stay inside a process
/// have no link.
std::vector<LayoutLink> layoutLinks(const Layout& layout, const TaskCatalog& catalog,
                                    const PlatformPackages& platform);

/// The graph of processes (with their tasks) and packages as text for Graphviz.
std::string layoutGraph(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

}  // namespace robotlink
