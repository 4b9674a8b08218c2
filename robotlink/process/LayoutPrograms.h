// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"

namespace robotlink {

struct Layout;

/// What is wrong with the programs of a layout: names that are repeated, programs without processes,
/// processes that are in none or in several or that do not exist, and hosts of which only some are named. A
/// part of checkLayout().
Errors checkPrograms(const Layout& layout);

}  // namespace robotlink
