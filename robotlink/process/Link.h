// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

namespace google::protobuf {
class Message;
}

namespace robotlink {

/// A package on its way: immutable and shared, so that it is never copied inside a process of the operating
/// system.
using PackagePtr = std::shared_ptr<const google::protobuf::Message>;

/// The way from one sender to one receiver. It holds at most two packages: one that was delivered and not yet
/// taken, and one that the sender was told to send and that the receiver has not yet asked for; a newer one
/// replaces the latter. A receiver asks again by taking.
///
/// Every transport (in a process, between processes, between machines) implements this and passes the same
/// conformance tests. offer() and delivered() are called by the sender's thread, take() by the receiver's;
/// implementations wake the process at the other end (Process::wake()) when its situation changes.
class Link {
 public:
  virtual ~Link() = default;

  /// Delivers the package if the receiver has asked for one, or keeps it until it does.
  virtual void offer(PackagePtr package) = 0;
  /// No package is kept: all that was offered was delivered or replaced.
  virtual bool delivered() const = 0;
  /// The newest package that is available, or null. Asks for the next one.
  virtual PackagePtr take() = 0;
  /// An end was stopped: nothing is kept or delivered from now on, what was delivered can still be taken.
  /// When it returns, the link touches neither process any more, so both may be destroyed. Idempotent; any
  /// thread.
  virtual void close() = 0;
  virtual bool closed() const = 0;
  /// How many packages a newer one has replaced.
  virtual std::uint64_t missed() const = 0;
};

}  // namespace robotlink
