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

/// A line to a robot: bytes in order, in both directions, over TCP, a serial line, or memory. Only
/// implementations of this interface call the operating system; they know nothing about packets.
///
/// One thread may read while another one writes, and any thread may close. After an error other than
/// "stream.busy" the line stays unusable: open a new one. Errors: "stream.closed" (closed on this side),
/// "stream.lost" (the far end closed it, or a serial adapter was unplugged), "stream.busy" (the far end
/// accepted no bytes for kWriteLimit; some bytes may have been sent).
class ByteStream {
 public:
  /// How long write() waits for a far end that accepts no bytes.
  static constexpr Duration kWriteLimit = std::chrono::seconds(2);

  virtual ~ByteStream() = default;

  /// Waits for bytes, at most `timeout` (0: does not wait), and reads as many as fit. Returns 0 if there were
  /// none. Bytes that arrived before the far end closed are still read before the error is returned.
  virtual Result<std::size_t> read(std::span<std::uint8_t> bytes, Duration timeout) = 0;

  /// Sends all bytes.
  virtual Result<void> write(std::span<const std::uint8_t> bytes) = 0;

  /// Closes the line; a thread that waits in read() returns at once. May be called repeatedly.
  virtual void close() = 0;

  /// The URL, for users and for opening the line again.
  virtual std::string address() const = 0;
};

}  // namespace robotlink::arcos
