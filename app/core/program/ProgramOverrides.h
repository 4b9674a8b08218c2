// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace app {

/// The user's overrides of a robot's layout and parameter files: modes of debug keys, solutions,
/// parameters, a color table, and recorded packages. It is applied to each program that is made for the
/// robot: after a reset, in another layout, at another place of a log. What one layout cannot fulfill is kept
/// for one that can. Which requests are overrides, and of what, says the table of requests. A plain value,
/// cheap to copy, the same for simulated, real and logged robots.
class ProgramOverrides {
 public:
  /// Keeps what an accepted request chose. Returns false, without effect, if requests of its kind are not
  /// overrides.
  bool note(const robotcontrol::Request& request);
  /// Chooses a solution by name, without a check.
  void chooseSolution(const std::string& task, const std::string& solution);
  /// Null removes the table.
  void chooseColorTable(const std::shared_ptr<const robotcontrol::ColorTable>& table);

  /// Whether the user chose what a request sets.
  bool contains(const robotcontrol::Request& request) const;
  /// Returns the requests that apply these overrides to a program that has not run yet, in the order in which
  /// they must be made. The last one asks for the program's tables.
  std::vector<robotcontrol::Request> requests(const std::string& robot) const;

  /// Modes of the debug keys that are on, by name. A mode that ends by itself (n times) is not kept.
  std::map<std::string, robotcontrol::KeyMode> keys() const;
  /// Solutions by task.
  std::map<std::string, std::string> solutions() const;
  /// The last parameters of each solution; an empty solution means the active one, and comes last.
  std::vector<robotcontrol::ParameterValues> parameters() const;
  /// Null if none was sent, or if the last request removed it.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable() const;
  /// The key-frame motions that were sent; null if there are none.
  std::shared_ptr<const robotcontrol::MotionTexts> motions() const;
  /// Packages that the program publishes whether or not their debug keys are on.
  std::vector<std::string> recordedPackages() const;

 private:
  /// The row of a kind in the table of requests, and what a request of that kind sets.
  using Subject = std::pair<std::size_t, std::string>;
  /// Only for kinds of requests that are overrides.
  static Subject subjectOf(const robotcontrol::Request& request);

  std::map<Subject, std::shared_ptr<const robotcontrol::Request>> requests_;
};

}  // namespace app
