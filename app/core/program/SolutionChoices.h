// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {
struct Layout;
struct TaskCatalog;
}  // namespace robotlink

namespace app {

/// What is wrong with the solutions that a person chose by their tasks: tasks and solutions that do not
/// exist, and tasks that none of the layouts has. Empty: all of them mean something in at least one layout.
robotlink::Errors checkSolutions(const std::map<std::string, std::string>& solutions,
                                 const robotlink::TaskCatalog& catalog,
                                 const std::vector<const robotlink::Layout*>& layouts);

}  // namespace app
