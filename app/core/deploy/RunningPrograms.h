// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace app {

/// Returns the path of a robot's preset in its resource folder, by the robot's name.
std::string presetPathOf(const std::string& robot);

/// The layouts in which the programs of a server's robots run, and the deployed files that they have not
/// read yet: a program reads its layout, parameters and motions when it starts. Any thread.
class RunningPrograms {
 public:
  /// A plain value.
  struct Program {
    std::string robot;
    /// The kind of robot: "ers210".
    std::string kind;
    /// The file of its layout: "compact.yaml".
    std::string layout;
    /// Files that take effect when it starts again: "motions/sit.mof".
    std::vector<std::string> waiting = {};
    bool operator==(const Program&) const = default;
  };

  /// Sets the programs that run; programs of other robots are forgotten.
  void set(const std::vector<Program>& programs);
  /// A file was written.
  void noteWritten(const std::string& path);
  /// The program of a robot has started again.
  void noteStarted(const std::string& robot);
  /// In the order of their robots.
  std::vector<Program> programs() const;

 private:
  struct Robot {
    std::string kind, layout;
    /// The number of the last file that its program has read.
    std::uint64_t read = 0;
  };

  /// Protects all members.
  mutable std::mutex mutex_;
  std::map<std::string, Robot> robots_;
  /// Their numbers count from 1, by path.
  std::map<std::string, std::uint64_t> written_;
  std::uint64_t newest_ = 0;
};

}  // namespace app
