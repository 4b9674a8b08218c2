// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace app::test {

/// Three machines and what connects them: the desk, where the test is; the computer of a robot, where its
/// program runs; and a robot on wheels, which that computer reaches. The line between desk and computer can
/// be lost.
class FarLine {
 public:
  /// A machine on which programs are started.
  struct Machine {
    /// The address that others reach.
    std::string address = "127.0.0.1";
    /// For StartedProgram::Options::network.
    int network = -1;
  };

  virtual ~FarLine() = default;
  virtual Machine computer() const = 0;
  virtual Machine wheels() const = 0;
  /// What a program on the computer is started with, so that the desk can connect to it with encryption and
  /// a token.
  virtual std::vector<std::string> listenOptions() const = 0;
  /// Where the desk reaches a program on the computer that has printed this URL.
  virtual std::string reached(const std::string& url) = 0;
  /// Loses the line, until it is called with false. Nobody is told.
  virtual void unplug(bool unplugged) = 0;
};

}  // namespace app::test
