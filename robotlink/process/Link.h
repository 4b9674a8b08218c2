// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

namespace google::protobuf {
class Message;
}

namespace robotlink {

/// A package in transit: immutable and shared, so that it is never copied within a process of the operating
/// system.
using PackagePtr = std::shared_ptr<const google::protobuf::Message>;

/// The connection from one sender to one receiver. It holds at most two packages: one that was delivered and
/// not yet taken, and one that was offered while the first was still there; a newer package replaces the
/// second one. Taking a package requests the next one.
///
/// Every transport (in a process, between processes, between machines) implements this interface and passes
/// the same conformance tests. offer() and delivered() are called by the sender's thread, take() by the
/// receiver's; implementations wake the process at the other end (EndOwner::wake()) when its situation
/// changes.
class Link {
 public:
  virtual ~Link() = default;

  /// Delivers the package if the receiver is ready for one; otherwise keeps it, in place of an older one,
  /// until it is.
  virtual void offer(PackagePtr package) = 0;
  /// True if no package is kept: all that were offered have been delivered or replaced.
  virtual bool delivered() const = 0;
  /// The newest package available, or null. Requests the next one.
  virtual PackagePtr take() = 0;
  /// Called when an end was stopped: nothing is kept or delivered from now on, but what was delivered can
  /// still be taken. After it returns, the link touches neither process, so both may be destroyed.
  /// Idempotent; any thread.
  virtual void close() = 0;
  /// Whether nothing is passed on: an end was stopped, or the program at the other end does not run.
  virtual bool closed() const = 0;
  /// Whether it is closed permanently. A link between programs opens again when the other one runs again.
  virtual bool ended() const { return closed(); }
  /// How many senders it has had: it grows when the program of the sender was started again. Always 0 within
  /// a program.
  virtual std::uint64_t generation() const { return 0; }
  /// How many packages were replaced by newer ones before they were taken. Any thread.
  virtual std::uint64_t missed() const = 0;
};

}  // namespace robotlink
