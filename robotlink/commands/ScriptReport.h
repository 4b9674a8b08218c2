// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace robotlink {

/// The outcome of a script, or of a file that it included.
struct ScriptOutcome {
  std::string name;
  /// Real time.
  double seconds = 0;
  /// "file:line: what was expected and what was there"; empty if it did not fail.
  std::string failure = {};
};

/// The outcomes as a JUnit XML file, with one test case each. Characters that XML cannot have are '?'.
std::string junitXml(const std::vector<ScriptOutcome>& outcomes);

}  // namespace robotlink
