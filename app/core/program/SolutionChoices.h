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

/// Checks the solutions that the user chose (task to solution) for robots with these layouts. Returns an
/// error for each task or solution that does not exist and for each task that none of the layouts has; empty
/// if every choice has an effect in at least one layout.
robotlink::Errors checkSolutions(const std::map<std::string, std::string>& solutions,
                                 const robotlink::TaskCatalog& catalog,
                                 const std::vector<const robotlink::Layout*>& layouts);

}  // namespace app
