// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/platform/HeadlessRun.h"

namespace app {

/// How `robotctl run --platform ws://HOST:PORT` runs the program of a body that is elsewhere.
HeadlessPlatform headlessBody();

}  // namespace app
