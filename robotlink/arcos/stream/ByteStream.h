// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// A line to a robot: bytes in order, both ways, over TCP, a serial line, or memory. It is what touches the
/// operating system and knows nothing of packets.
///
/// One thread may read while another writes, and any thread may close. Once it failed with an error whose id
/// is not "stream.busy" it stays so: open a new one. Errors: "stream.closed" (closed here), "stream.lost"
/// (the far end closed it, or a serial adapter was unplugged), "stream.busy" (the far end took no bytes for
/// kWriteLimit; some may have been sent).
class ByteStream {
 public:
  /// How long write() waits for a far end that takes nothing.
  static constexpr Duration kWriteLimit = std::chrono::seconds(2);

  virtual ~ByteStream() = default;

  /// Waits until there are bytes, but at most `timeout` (0: does not wait), and takes as many as fit. 0 if
  /// there were none. What came before the far end went is still read, before the error.
  virtual Result<std::size_t> read(std::span<std::uint8_t> bytes, Duration timeout) = 0;

  /// Sends all of them.
  virtual Result<void> write(std::span<const std::uint8_t> bytes) = 0;

  /// Ends it; a thread that waits in read() returns at once. May be called twice.
  virtual void close() = 0;

  /// The URL it was opened by, for people and for opening it again.
  virtual std::string address() const = 0;
};

}  // namespace robotlink::arcos
