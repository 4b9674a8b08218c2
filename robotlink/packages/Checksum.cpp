// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Checksum.h"

#include <google/protobuf/message_lite.h>

#include <algorithm>

#include "robotlink/base/bytes/Fnv.h"

namespace robotlink {

std::uint64_t checksum(const google::protobuf::MessageLite& message) {
  return std::max<std::uint64_t>(fnv1a(message.SerializeAsString()), 1);
}

}  // namespace robotlink
