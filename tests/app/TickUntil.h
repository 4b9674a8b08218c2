// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/Workbench.h"
#include "tests/Eventually.h"

namespace app::test {

/// Ticks the workbench, as its window does, until a condition holds; false: it does not hold in time.
template <typename Condition>
bool tickUntil(Workbench& workbench, Condition condition) {
  return eventually([&] {
    workbench.tick();
    return condition();
  });
}

}  // namespace app::test
