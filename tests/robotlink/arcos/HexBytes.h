// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// Converts a text such as "FA FB 03" to bytes; spaces are ignored.
inline Bytes hexBytes(std::string_view text) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
  Bytes bytes;
  int high = -1;
  for (const char c : text) {
    if (c == ' ') continue;
    if (high < 0) {
      high = digit(c);
    } else {
      bytes.push_back(static_cast<std::uint8_t>(high * 16 + digit(c)));
      high = -1;
    }
  }
  return bytes;
}

}  // namespace robotlink::arcos
