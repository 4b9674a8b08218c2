// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

#include "robotlink/arcos/stream/ByteStream.h"

namespace robotlink::arcos {

/// A line over a file descriptor, the base of TcpStream and SerialStream, which open it with Boost.Asio.
/// Asio's objects must not be used by two threads at once; with poll(2) one thread can read with a time limit
/// while another one writes. The descriptor is closed by the destructor, not by close(), because another
/// thread may still be using it.
class DescriptorStream : public ByteStream {
 public:
  ~DescriptorStream() override;
  DescriptorStream(const DescriptorStream&) = delete;
  DescriptorStream& operator=(const DescriptorStream&) = delete;

  Result<std::size_t> read(std::span<std::uint8_t> bytes, Duration timeout) final;
  Result<void> write(std::span<const std::uint8_t> bytes) final;
  void close() override;
  std::string address() const final { return address_; }

 protected:
  /// Takes ownership of `descriptor` and makes it non-blocking.
  DescriptorStream(int descriptor, std::string address);
  int descriptor() const { return descriptor_; }

 private:
  /// The result of waiting for the descriptor.
  enum class Wait { kReady, kTimedOut, kClosed };
  Wait waitFor(short events, Duration timeout) const;
  tl::unexpected<Error> closedHere() const;
  tl::unexpected<Error> failed(int error) const;

  /// The sentence about the loss of the far end; `error` is an errno, or 0 if it closed the line properly.
  virtual std::string describeLoss(int error) const = 0;
  /// Calls the system's write function once; returns -1 with errno set on failure.
  virtual ssize_t writeSome(std::span<const std::uint8_t> bytes) = 0;

  const int descriptor_;
  /// An eventfd that wakes up waiting threads when the line is closed.
  const int wake_;
  const std::string address_;
  std::atomic<bool> closed_ = false;
};

}  // namespace robotlink::arcos
