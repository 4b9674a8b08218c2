// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace app {

/// What the user chose for a robot's program against its layout and files: modes of debug keys, solutions,
/// parameters, a color table, and recorded packages. It is applied to each program that is made for the
/// robot: after a reset, in another layout, at another place of a log. What one layout cannot fulfill is kept
/// for one that can. A plain value, the same for simulated, real and logged robots.
class ProgramOverrides {
 public:
  /// A task and one of its solutions; an empty solution means the active one.
  using TaskSolution = std::pair<std::string, std::string>;

  /// Keeps what an accepted request chose. Returns false, without effect, if requests of its kind are not
  /// overrides.
  bool note(const robotcontrol::Request& request);
  /// Chooses a solution by name, without a check.
  void chooseSolution(const std::string& task, const std::string& solution) { solutions_[task] = solution; }
  /// Null removes the table.
  void chooseColorTable(std::shared_ptr<const robotcontrol::ColorTable> table) {
    colorTable_ = std::move(table);
  }

  /// Returns the requests that apply these overrides to a program that has not run yet, in the order in which
  /// they must be made. The last one asks for the program's tables. Recorded packages are not included.
  std::vector<robotcontrol::Request> requests(const std::string& robot) const;

  /// Modes of the debug keys that are on, by name. A mode that ends by itself (n times) is not kept.
  const std::map<std::string, robotcontrol::KeyMode>& keys() const { return keys_; }
  /// Solutions by task.
  const std::map<std::string, std::string>& solutions() const { return solutions_; }
  /// The last parameters of each solution.
  const std::map<TaskSolution, robotcontrol::ParameterValues>& parameters() const { return parameters_; }
  /// Null if none was sent, or if the last request removed it.
  const std::shared_ptr<const robotcontrol::ColorTable>& colorTable() const { return colorTable_; }
  /// Packages that the program publishes whether or not their debug keys are on.
  const std::vector<std::string>& recordedPackages() const { return recordedPackages_; }

 private:
  void noteKey(const robotcontrol::SetKey& key);
  void noteParameters(const robotcontrol::SetParameters& details);

  std::map<std::string, robotcontrol::KeyMode> keys_;
  std::map<std::string, std::string> solutions_;
  std::map<TaskSolution, robotcontrol::ParameterValues> parameters_;
  std::shared_ptr<const robotcontrol::ColorTable> colorTable_;
  std::vector<std::string> recordedPackages_;
};

}  // namespace app
