// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

#include "robotlink/arcos/stream/ByteStream.h"

namespace robotlink::arcos {

/// A line over a file descriptor of the operating system, which a TcpStream or a SerialStream opened with
/// Boost.Asio. Asio's own objects may not be used by two threads at once; poll(2) lets one read with a time
/// limit while another writes. The destructor gives the descriptor back; close() does not, since another
/// thread may be about to use it.
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
  /// Owns `descriptor`, and makes it non-blocking.
  DescriptorStream(int descriptor, std::string address);
  int descriptor() const { return descriptor_; }

 private:
  enum class Wait { kReady, kTimedOut, kClosed };
  Wait waitFor(short events, Duration timeout) const;
  tl::unexpected<Error> closedHere() const;
  tl::unexpected<Error> failed(int error) const;

  /// The sentence about a far end that went; `error` is an errno, or 0 where it went in good order.
  virtual std::string describeLoss(int error) const = 0;
  virtual ssize_t writeSome(std::span<const std::uint8_t> bytes) = 0;

  const int descriptor_;
  const int wake_;  // an eventfd that wakes who waits when the line is closed
  const std::string address_;
  std::atomic<bool> closed_ = false;
};

}  // namespace robotlink::arcos
