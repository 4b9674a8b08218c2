// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/arcos/stream/ByteStream.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace robotlink::arcos {

/// Connects to a robot, or its simulator, over TCP: to each address of the host in turn, until one answers or
/// the time is up. Small packets leave at once (no Nagle).
Result<std::unique_ptr<ByteStream>> openTcp(const TcpAddress& address, Duration timeLimit);

}  // namespace robotlink::arcos
