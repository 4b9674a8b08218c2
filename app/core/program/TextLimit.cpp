// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TextLimit.h"

#include <algorithm>

namespace app {

bool TextLimit::admit(RealTime now) {
  const double passed = std::chrono::duration<double>(now - refilled_).count();
  tokens_ = std::min<double>(kBurst, tokens_ + passed * kPerSecond);
  refilled_ = now;
  if (tokens_ >= 1) {
    tokens_ -= 1;
    return true;
  }
  if (suppressed_++ == reported_) counted_ = now;
  return false;
}

std::uint64_t TextLimit::takeSuppressed(RealTime now) {
  if (suppressed_ == reported_ || now - counted_ < std::chrono::seconds(1)) return 0;
  const std::uint64_t count = suppressed_ - reported_;
  reported_ = suppressed_;
  return count;
}

}  // namespace app
