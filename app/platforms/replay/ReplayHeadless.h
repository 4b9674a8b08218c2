// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/platform/HeadlessRun.h"

namespace app {

/// Returns the runner that replays logs without a window: the programs of their robots run from the first
/// instant to the last, as fast as possible. Logged and recomputed data are recorded, if that is
/// requested; the same logs and choices give the same bytes. The summary compares both.
HeadlessPlatform headlessReplay();

}  // namespace app
