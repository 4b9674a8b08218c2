// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robotlink {
class Process;
}

namespace app {

/// The report that a robot's program wrote about itself when it crashed, called exit(), or was asked because
/// it did not answer. A plain value.
struct CrashReport {
  /// The task and solution that was executed: "ball-percept (region)"; empty: none.
  std::string activity;
  /// The process of the layout that executed it; empty: none.
  std::string process;
  /// The calls that led there, innermost first, a line each, as far as they are known.
  std::string stack;

  /// Reads the report of the program's end in a text, or, without one, the last that was requested; empty
  /// if there is none.
  static CrashReport parse(std::string_view text);
  /// Whether a text has a report of the program's end.
  static bool hasEnd(std::string_view text);
  /// " in ball-percept (region) of process cognition", or an empty text.
  std::string place() const;

  // In the program itself, once each, in its main thread:
  /// From now on writes a report to a file descriptor at fatal signals, at exit(), and at kAskSignal.
  static void install(int descriptor);
  /// The processes of which a report may say what they do; they must exist until the program ends.
  static void watch(const std::vector<robotlink::Process*>& processes);
  // With a thread for each process:
  /// Call this in the thread of a process; reports of this thread then are about that process.
  static void enterThread(const robotlink::Process& process);
  /// Makes the next requested reports be about the thread of this process; null: any.
  static void suspect(const robotlink::Process* process);
};

/// The signal at which a program writes a report and continues.
int askSignal();

/// Describes a program's end, by its waitpid() status: "crashed with a segmentation fault", "called exit(3)".
std::string endInWords(int status);

}  // namespace app
