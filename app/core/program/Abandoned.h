// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace app {

// Modules that never return cannot be ended. What they use is abandoned: it exists until they return after
// all, in a thread that waits for that, while everything else continues without it.

/// Destroys `what` when `hasEnded` returns true, in a thread of its own.
void abandon(std::shared_ptr<void> what, std::function<bool()> hasEnded);
/// Returns the number of these. While there are some, the process of the operating system has to be left by
/// leave().
int abandonedCount();
/// Ends the process of the operating system at once, if modules run that cannot be ended; else returns.
void leave(int status);

}  // namespace app
