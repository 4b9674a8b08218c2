// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/arcos/stream/ByteStream.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace robotlink::arcos {

/// Opens a serial line to a robot: 8 data bits, no parity, one stop bit, no flow control. While it is open,
/// other programs that lock devices (flock) cannot open it. Reading fails when an adapter is unplugged; open
/// the line again when it is back.
Result<std::unique_ptr<ByteStream>> openSerial(const SerialAddress& address);

}  // namespace robotlink::arcos
