// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink {

/// A named switch in the code, declared next to the code that it switches, at namespace scope:
///
///     const DebugKey kCircleKey{"ball-percept/circle", "The circle that was fitted to the ball's edge"};
///
/// All keys of the program are known before main() starts, whatever the order in which files are initialized.
/// A key is only an index; its mode and counters are in the DebugContext of each process. Names are unique
/// paths of lower-case letters, digits and '-', separated by '/', and start with the task. An invalid or
/// repeated name aborts the program at its start with a message.
class DebugKey {
 public:
  DebugKey(const char* name, const char* help);
  /// The index in all(); -1 for a key of another file whose constructor has not run yet.
  int index() const { return number_ - 1; }
  const std::string& name() const;

  /// The name of a key, and a sentence for users on what it shows.
  struct Entry {
    std::string name;
    std::string help;
  };
  /// All keys by index. Read-only once main() has started.
  static const std::vector<Entry>& all();
  /// The index of the key of this name; -1 if there is none.
  static int find(const std::string& name);
  /// Makes the construction of further keys a programming error. Called by code that has allocated tables of
  /// the size of all().
  static void seal();

 private:
  /// The index + 1, so that 0, the value before construction, is not a valid key.
  int number_ = 0;
};

}  // namespace robotlink
