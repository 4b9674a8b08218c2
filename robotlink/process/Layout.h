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

/// A process layout as its file says: which process does which tasks, by which solution at the start. A plain
/// value; every part knows its place in the file, for errors. The format is described in
/// robotlink/process/LAYOUTS.md.
struct Layout {
  struct Task {
    std::string task;
    std::string solution;  ///< at the start
    FilePosition where;
    std::string ownSolution = {};  ///< not in files: the layout's, if another one was chosen instead

    /// Starts with another solution than the layout's own.
    void choose(const std::string& chosen) {
      if (ownSolution.empty()) ownSolution = solution;
      solution = chosen;
    }
  };
  struct Input {
    std::string package;
    FilePosition where;
    bool paceOnly = false;  ///< none of its tasks needs to read it: it only says when to run
  };
  struct Process {
    std::string name;
    int priority = 0;             ///< nice value, -20 to 19
    Duration period{0};           ///< 0: event-driven
    bool debug = false;           ///< collects all debug queues and hands requests out; has no tasks
    std::vector<Task> tasks;      ///< in the order of their execution
    std::vector<Input> blocking;  ///< packages from other processes that it waits for
    FilePosition where;
  };
  /// A task that does not run although whoever made the layout has it, for people to see.
  struct Absence {
    std::string process;
    std::string task;
    std::string reason;  ///< "nobody offers joints/states"
  };
  std::string name;
  std::string help;
  std::string file;
  std::vector<Process> processes;  ///< in the order of their execution in lockstep

  // Not in files: what remains of a layout that is put on less than it was made for, such as a log.
  std::vector<Absence> absent;
  /// Packages that its tasks keep to themselves, because something else offers them.
  std::set<std::string> withheld;
};

/// What the layout is put on: the packages that the platform offers and takes
/// (resources/robots/<robot>.yaml), and those that the debug process offers (a person's wishes:
/// remote/motion).
struct PlatformPackages {
  std::vector<std::string> offers;
  std::vector<std::string> takes;
  std::vector<std::string> debugOffers;
};

/// Reads a file's form only; every problem found is reported, each with its place.
tl::expected<Layout, Errors> readLayout(const std::filesystem::path& file);
tl::expected<Layout, Errors> parseLayout(const std::string& text, const std::string& file);

/// One link that follows from inputs and outputs. An empty process name is the platform.
struct LayoutLink {
  std::string package;
  std::string from;
  std::string to;
  bool blocking = false;
  bool optional = false;
  bool operator==(const LayoutLink&) const = default;
};

/// Everything that makes a layout unusable, each with its place and what to do about it: unknown or repeated
/// task, solution or name; a default solution that is unavailable; an input that nobody produces; an output
/// produced twice; a cycle inside a process; a cycle of blocking inputs between processes; a process with
/// neither a blocking input nor a period; a blocking input that no task of the process uses. Empty: it can be
/// run.
Errors checkLayout(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

/// Why a solution cannot run in a layout that checkLayout() accepted; empty if it can. "unavailable because
/// nobody offers oracle/world".
std::string unavailability(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform,
                           const std::string& task, const std::string& solution);

/// The links between processes, for all solutions of the layout's tasks (so that a solution can be switched
/// without relinking), in the order of the layout. Packages that stay inside a process are not in it.
std::vector<LayoutLink> layoutLinks(const Layout& layout, const TaskCatalog& catalog,
                                    const PlatformPackages& platform);

/// The graph of processes (with their tasks) and packages as Graphviz text.
std::string layoutGraph(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

}  // namespace robotlink
