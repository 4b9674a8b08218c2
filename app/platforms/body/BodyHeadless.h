// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/platform/HeadlessRun.h"

namespace app {

/// Returns the headless runner for the program of a remote body (`robotctl run --platform ws://HOST:PORT`).
HeadlessPlatform headlessBody();

}  // namespace app
