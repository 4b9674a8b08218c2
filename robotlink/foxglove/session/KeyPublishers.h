// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace robotcontrol {
class KeyTable;
class ProcessTable;
}  // namespace robotcontrol

namespace robotlink::websocket {

/// Finds the process of a remote robot that publishes the output of a debug key, from the tables of its
/// processes. A message of a hosted robot names its process; over a link it has to be known, since
/// drawings belong to frames of their processes (FrameDrawings.h). One thread.
class KeyPublishers {
 public:
  /// Takes the table of one process.
  void setKeys(const std::string& process, const robotcontrol::KeyTable& keys);
  /// Forgets processes that are not in this table, because the robot has another layout now.
  void setProcesses(const robotcontrol::ProcessTable& processes);
  /// The process that publishes a stream ("drawings/image/ball-percept/disc"); empty if that is unknown, or
  /// if several processes have its key.
  std::string processOf(const std::string& stream) const;

 private:
  /// The streams of keys, by process.
  std::map<std::string, std::set<std::string>> streams_;
};

}  // namespace robotlink::websocket
