// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/arcos/stream/ByteStream.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace robotlink::arcos {

/// Connects to a robot or its simulator over TCP: tries the host's addresses in turn until one accepts or the
/// time is up. Small packets are sent immediately (no Nagle).
Result<std::unique_ptr<ByteStream>> openTcp(const TcpAddress& address, Duration timeLimit);

}  // namespace robotlink::arcos
