// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink {

/// Lets the allocator of this program keep what is freed, up to some hundred megabytes, for what is allocated
/// next. A window frees and allocates megabytes in each frame, for pictures above all. By default those come
/// fresh from the system each time, and each page of them costs a page fault: 0.5 us, and 20 us on nested
/// virtual machines, where opening a few views could keep the window from answering for 100 ms.
///
/// Call it once, before memory is allocated in large amounts. Without effect where the C library is not
/// GNU's.
void keepFreedMemory();

}  // namespace robotlink
