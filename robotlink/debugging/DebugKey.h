// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink {

/// A named switch in the code, declared beside the code that it switches, at namespace scope:
///
///     const DebugKey kCircleKey{"ball-percept/circle", "The circle that was fitted to the ball's edge"};
///
/// All keys of the program are known before main() starts, in whatever order files are initialised. A key is
/// only an index; its mode and its counters live in the DebugContext of each process. Names are paths with
/// '/', lower case, and start with the task; they are unique. A name that is not ends the program at its
/// start with a text that says why.
class DebugKey {
 public:
  DebugKey(const char* name, const char* help);
  /// -1 for a key of another file whose constructor has not run yet.
  int index() const { return number_ - 1; }
  const std::string& name() const;

  struct Entry {
    std::string name;
    std::string help;
  };
  /// All keys by index; read-only after main() has started.
  static const std::vector<Entry>& all();
  /// The index of the key of that name; -1 if there is none.
  static int find(const std::string& name);
  /// From now on a further key is a programming error: called by who has made tables as long as all().
  static void seal();

 private:
  int number_ = 0;  // from 1, so that a key that is not constructed yet (all zero) is told from the first
};

}  // namespace robotlink
