// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/debugging/Streams.h"

namespace robotlink {

/// A named switch in the code, declared next to the code that it switches, at namespace scope:
///
///     const ImageDrawingKey kCircleKey{"ball-percept/circle", "The circle that was fitted to the ball's
///     edge"};
///
/// Its type says what it publishes, and so on which stream: one can ask for a key's stream before anything
/// was ever published on it.
///
/// All keys of the program are known before main() starts, whatever the order in which files are initialized.
/// A key is only an index; its mode and counters are in the DebugContext of each process. Names are unique
/// paths of lower-case letters, digits and '-', separated by '/', and start with the task. An invalid or
/// repeated name aborts the program at its start with a message.
class DebugKey {
 public:
  /// The index in all(); -1 for a key of another file whose constructor has not run yet.
  int index() const { return number_ - 1; }
  const std::string& name() const;
  const std::string& stream() const;

  /// The name of a key, a sentence for users on what it shows, and the path of its stream below the robot (of
  /// plots with several curves the path that precedes these).
  struct Entry {
    std::string name;
    std::string help;
    std::string stream;
  };
  /// All keys by index. Read-only once main() has started.
  static const std::vector<Entry>& all();
  /// The index of the key of this name; -1 if there is none.
  static int find(const std::string& name);
  /// Makes the construction of further keys a programming error. Called by code that has allocated tables of
  /// the size of all().
  static void seal();

 protected:
  DebugKey(const char* name, const char* help, std::string stream);

 private:
  /// The index + 1, so that 0, the value before construction, is not a valid key.
  int number_ = 0;
};

/// A debug key whose messages are on the stream `kStreams` + name; kStreams is one of Streams.h.
template <const char* kStreams>
class DebugKeyOf : public DebugKey {
 public:
  DebugKeyOf(const char* name, const char* help) : DebugKey(name, help, std::string(kStreams) + name) {}
};

using ImageDrawingKey = DebugKeyOf<streams::kImageDrawings>;
using FieldDrawingKey = DebugKeyOf<streams::kFieldDrawings>;
using RobotDrawingKey = DebugKeyOf<streams::kRobotDrawings>;
using ImageKey = DebugKeyOf<streams::kImages>;
using PlotKey = DebugKeyOf<streams::kPlots>;
/// A key that switches the stopwatches of all processes, each on a stream of its own.
class StopwatchKey : public DebugKey {
 public:
  StopwatchKey(const char* name, const char* help) : DebugKey(name, help, "stopwatches") {}
};

}  // namespace robotlink
