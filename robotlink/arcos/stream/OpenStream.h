// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "robotlink/arcos/stream/ByteStream.h"

namespace robotlink::arcos {

/// A function that opens a line, called for each connection.
using StreamOpener = std::function<Result<std::unique_ptr<ByteStream>>()>;

/// Opens a line by its URL: "tcp://localhost:8101" or "serial:///dev/ttyUSB0?baud=9600" (see StreamUrl.h).
/// Blocks for at most `timeLimit`, except that looking up a host's name may take as long as the system
/// allows. The error's text says what is wrong and what to do.
Result<std::unique_ptr<ByteStream>> open(const std::string& url,
                                         Duration timeLimit = std::chrono::seconds(5));

}  // namespace robotlink::arcos
