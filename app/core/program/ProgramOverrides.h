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

/// What a person chose for a robot's program against its layout and its files, and what every program that is
/// made for this robot shall have again, after a reset, in another layout, at another place of a log: modes
/// of debug keys, solutions, parameters, the color table, and what is recorded. What a layout cannot fulfill
/// is kept for one that can. A plain value, the same for simulated, real and logged robots.
class ProgramOverrides {
 public:
  using TaskSolution = std::pair<std::string, std::string>;

  /// A request that the program does; of other kinds nothing is kept. Whether anything was.
  bool note(const robotcontrol::Request& request);
  void chooseSolution(const std::string& task, const std::string& solution) { solutions_[task] = solution; }
  void chooseColorTable(std::shared_ptr<const robotcontrol::ColorTable> table) {
    colorTable_ = std::move(table);
  }

  /// What to ask a program that has not run yet; the last one asks for its tables.
  std::vector<robotcontrol::Request> requests(const std::string& robot) const;

  const std::map<std::string, robotcontrol::KeyMode>& keys() const { return keys_; }
  const std::map<std::string, std::string>& solutions() const { return solutions_; }
  const std::map<TaskSolution, robotcontrol::ParameterValues>& parameters() const { return parameters_; }
  /// Null: none was sent.
  const std::shared_ptr<const robotcontrol::ColorTable>& colorTable() const { return colorTable_; }
  /// That are told whether or not their keys are on.
  const std::vector<std::string>& recordedPackages() const { return recordedPackages_; }

 private:
  void noteKey(const robotcontrol::SetKey& key);
  void noteParameters(const robotcontrol::SetParameters& details);

  std::map<std::string, robotcontrol::KeyMode> keys_;  // by name
  std::map<std::string, std::string> solutions_;       // by task
  std::map<TaskSolution, robotcontrol::ParameterValues> parameters_;
  std::shared_ptr<const robotcontrol::ColorTable> colorTable_;
  std::vector<std::string> recordedPackages_;
};

}  // namespace app
