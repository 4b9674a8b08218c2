// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/KeptMemory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace robotlink {

void keepFreedMemory() {
#ifdef __GLIBC__
  // Larger blocks still come from the system each time: it is the highest threshold that the library takes.
  constexpr int kLarge = 32 << 20;
  constexpr int kKept = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

}  // namespace robotlink
