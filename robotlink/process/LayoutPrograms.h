// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

struct Layout;
struct LayoutLink;

/// Checks the programs of a layout. Problems are names that are repeated, programs without processes,
/// processes that are in none or in several or that do not exist, and hosts of which only some are named. A
/// part of checkLayout().
Errors checkPrograms(const Layout& layout);

/// The processes that decide what the platform does: those that send it packages, and those from which their
/// packages come, directly or through others. If one of them is missing, the others command the platform by
/// what was true when it was there.
std::set<std::string> commandingProcesses(const std::vector<LayoutLink>& links);

}  // namespace robotlink
