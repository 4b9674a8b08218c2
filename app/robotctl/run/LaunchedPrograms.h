// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// Programs that this one has started and whose output it prints, each line behind the name of its program.
/// They get SIGTERM when this program ends, however it ends. One thread, which has to live as long as this
/// object, since the system counts it as their parent.
class LaunchedPrograms {
 public:
  explicit LaunchedPrograms(std::ostream& out) : out_(out) {}
  /// Ends all that still run, at once.
  ~LaunchedPrograms();
  LaunchedPrograms(const LaunchedPrograms&) = delete;
  LaunchedPrograms& operator=(const LaunchedPrograms&) = delete;

  /// Starts this executable with other arguments. `again` is what a user types to start it again.
  robotlink::Result<void> start(const std::string& name, const std::vector<std::string>& arguments,
                                const std::string& again);
  /// Prints what the programs have written, and who has ended. Blocks for a moment if there is nothing.
  void look();
  /// Asks all that run to end.
  void interrupt();
  void kill();
  bool anyRuns() const;
  /// Whether one has ended otherwise than it should.
  bool anyFailed() const { return failed_; }

 private:
  struct Program {
    std::string name;
    std::string again;
    ::pid_t pid = 0;  // 0: it has ended
    int output = -1;  // the end of its output that is read; -1: closed
    std::string line = {};
  };
  void signalAll(int signal);
  void read(Program& program);
  void printLine(const Program& program, const std::string& line);
  void noteEnd(Program& program);

  std::ostream& out_;
  std::vector<Program> programs_;
  bool asked_ = false;  // to end
  bool failed_ = false;
};

}  // namespace app
