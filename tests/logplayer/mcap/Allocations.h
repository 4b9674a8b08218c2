// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace logplayer::mcap::test {

/// The most memory that was taken by operator new beyond what was taken when this was made. For programs that
/// are linked with Allocations.cpp; one at a time.
class LargestAllocation {
 public:
  LargestAllocation();
  std::size_t bytes() const;

 private:
  std::size_t before_;
};

}  // namespace logplayer::mcap::test
