// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iosfwd>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace robotcontrol {
class HostingStatus;
}

namespace app {

/// Prints what goes wrong with the programs of robots, as it happens, for people at a console, and keeps it
/// for the end: programs that crashed or do not answer, and processes that were stopped. Any thread.
class ProgramTroubles {
 public:
  struct Trouble {
    std::string robot, text;
    bool operator==(const Trouble&) const = default;
  };
  /// The maximum number that is kept; further ones are only printed.
  static constexpr std::size_t kMaxTroubles = 1000;

  /// The stream must outlive it.
  explicit ProgramTroubles(std::ostream& out) : out_(out) {}

  /// Call this when the hosting of a robot's program has changed. Prints the text and the stack, if there
  /// are any that have not been printed since the program ran.
  void note(const std::string& robot, const robotcontrol::HostingStatus& status);
  /// Something is wrong with a process: "Process cognition was stopped because it threw: ..." is kept; that
  /// it starves, or has another priority, is only printed.
  void note(const std::string& robot, const std::string& text);
  std::vector<Trouble> all() const;
  bool any() const { return !all().empty(); }

 private:
  void keep(const std::string& robot, const std::string& text);

  std::ostream& out_;
  /// Protects the members below and the stream.
  mutable std::mutex mutex_;
  std::vector<Trouble> all_;
  /// The text about each robot's program that was printed last.
  std::map<std::string, std::string> printed_;
};

}  // namespace app
