// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink {

/// A named switch in the code, declared beside the code that it switches:
///
///     const DebugKey kCircleKey{"ball-percept/circle", "The circle that was fitted to the ball's edge"};
///
/// All keys of the program are known before main() starts. A key is only an index; its mode and its counters live in
/// the DebugContext of each process. Names are paths with '/', lower case, and start with the task; they are unique.
class DebugKey {
 public:
  DebugKey(const char* name, const char* help);
  int index() const { return index_; }
  const std::string& name() const;

  struct Entry {
    std::string name;
    std::string help;
  };
  /// All keys by index; read-only after main() has started.
  static const std::vector<Entry>& all();

 private:
  int index_;
};

}  // namespace robotlink
