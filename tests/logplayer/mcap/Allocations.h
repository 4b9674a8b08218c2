// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace logplayer::mcap::test {

/// Measures the peak of memory allocated by operator new since its construction. For programs that are linked
/// with Allocations.cpp; one object at a time.
class LargestAllocation {
 public:
  LargestAllocation();
  /// The peak in excess of the memory allocated at construction.
  std::size_t bytes() const;

 private:
  std::size_t before_;
};

}  // namespace logplayer::mcap::test
