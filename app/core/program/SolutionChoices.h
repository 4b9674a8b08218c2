// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/debugging/DebugRoutes.h"

namespace robotlink {
struct Layout;
struct TaskCatalog;
}  // namespace robotlink

namespace app {

/// The two sides of "TASK=SOLUTION"; unset if one of them is missing.
std::optional<std::pair<std::string, std::string>> assignmentOf(const std::string& text);
/// The solutions that such texts choose, by task. Fails if one of them is invalid.
robotlink::Result<std::map<std::string, std::string>> solutionsOf(const std::vector<std::string>& texts);

/// A solution that is chosen for a robot or a team.
struct SolutionChoice {
  /// Empty: for all robots.
  std::string name;
  std::string task, solution;
};
/// Parses the text of an option ("--solution"): "TASK=SOLUTION" or "NAME/TASK=SOLUTION". Fails if it is
/// invalid.
robotlink::Result<SolutionChoice> solutionChoiceOf(const std::string& text, const std::string& option);

/// The solutions that such texts let run in shadow mode. Fails if one of them is
/// invalid, or if there is no such solution.
robotlink::Result<std::vector<robotlink::ShadowName>> shadowsOf(const std::vector<std::string>& texts);
/// Fails if there is no such solution, with those that there are.
robotlink::Result<void> checkShadow(const robotlink::ShadowName& shadow);

/// Checks the solutions that the user chose (task to solution) for robots with these layouts. Returns an
/// error for each task or solution that does not exist and for each task that none of the layouts has; empty
/// if every choice has an effect in at least one layout.
/// See also checkShadows().
robotlink::Errors checkSolutions(const std::map<std::string, std::string>& solutions,
                                 const robotlink::TaskCatalog& catalog,
                                 const std::vector<const robotlink::Layout*>& layouts);

/// The same for solutions that are to run in shadow mode; also an error if each layout that has the task uses
/// the solution itself.
robotlink::Errors checkShadows(const std::vector<robotlink::ShadowName>& shadows,
                               const robotlink::TaskCatalog& catalog,
                               const std::vector<const robotlink::Layout*>& layouts);

}  // namespace app
