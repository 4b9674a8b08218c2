// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"

namespace app {

/// What a person asked of a robot's program and what one that is made anew shall have again: modes of debug keys, by name, and
/// solutions, by task. A plain value.
class ProgramWishes {
 public:
  /// A request that is handed to the program; of other kinds nothing is kept.
  void note(const robotcontrol::Request& request);
  /// Another layout has solutions of its own.
  void forgetSolutions() { solutions_.clear(); }
  /// What to ask a program that has not run yet; the last one asks for its tables.
  std::vector<robotcontrol::Request> requests(const std::string& robot) const;

 private:
  std::map<std::string, robotcontrol::KeyMode> keys_;
  std::map<std::string, std::string> solutions_;
};

}  // namespace app
