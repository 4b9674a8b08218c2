// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/threads/OdeThread.h"

#include <ode/ode.h>

namespace simcore {

void prepareOdeForThread() {
  static const bool kInitialized = dInitODE2(0) != 0;
  constexpr auto kAllData = static_cast<unsigned>(dAllocateMaskAll);
  thread_local const bool kAllocated = kInitialized && dAllocateODEDataForThread(kAllData) != 0;
  (void)kAllocated;
}

}  // namespace simcore
