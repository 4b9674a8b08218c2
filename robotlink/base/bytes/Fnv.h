// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace robotlink {

/// The hash function FNV-1a with 64 bits (G. Fowler, L. C. Noll, K.-P. Vo): the same on all machines, and
/// easy to forge, so it only tells things apart.
constexpr std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

}  // namespace robotlink
