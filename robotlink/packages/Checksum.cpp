// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Checksum.h"

#include <google/protobuf/message_lite.h>

#include <algorithm>

namespace robotlink {

std::uint64_t checksum(const google::protobuf::MessageLite& message) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : message.SerializeAsString())
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return std::max<std::uint64_t>(hash, 1);
}

}  // namespace robotlink
