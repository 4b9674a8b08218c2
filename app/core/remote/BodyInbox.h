// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "robotcontrol/Body.pb.h"
#include "robotlink/base/Clock.h"

namespace app {

/// The commands from remote programs on their way to the bodies of the robots here. A body obeys one
/// program at a time: the one that commanded it first, until it sent nothing for kGivenUp. Any thread.
class BodyInbox {
 public:
  static constexpr robotlink::Duration kGivenUp = std::chrono::seconds(2);

  /// The name of the program that commands, as others see it.
  struct Sender {
    std::uint64_t id = 0;
    std::string name;
  };

  /// A newer command replaces one that was not taken. `now` is real time. Returns why it is refused; empty if
  /// it is not.
  std::string put(const std::string& robot, const Sender& from, robotcontrol::BodyCommands commands,
                  robotlink::Instant now);
  /// Removes and returns the newest command for a robot.
  std::optional<robotcontrol::BodyCommands> take(const std::string& robot);
  /// The name of the program that commanded a robot last; empty: none yet.
  std::string commander(const std::string& robot) const;

 private:
  struct Robot {
    Sender commander;
    robotlink::Instant heard;
    std::optional<robotcontrol::BodyCommands> newest;
  };

  /// Protects robots_.
  mutable std::mutex mutex_;
  std::map<std::string, Robot> robots_;
};

}  // namespace app
