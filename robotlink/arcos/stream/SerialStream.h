// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/arcos/stream/ByteStream.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace robotlink::arcos {

/// Opens a serial line to a robot: 8 data bits, no parity, one stop bit, no flow control. Until it is
/// destroyed no other program that locks devices (flock) gets it. When an adapter was unplugged, reading
/// fails; open it again when it is back.
Result<std::unique_ptr<ByteStream>> openSerial(const SerialAddress& address);

}  // namespace robotlink::arcos
