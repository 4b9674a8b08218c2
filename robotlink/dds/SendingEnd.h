// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "robotlink/dds/EndSetup.h"
#include "robotlink/dds/Wire.h"
#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Link.h"

namespace robotlink::dds {

/// The sending half of the links from one sender to all receivers of its package in other programs; for the
/// sender it is one link. A package is serialized and written once, however many receive it, and not at all
/// while none does. Receivers come and go: an end without any is closed, but not permanently.
///
/// Each package that is offered is written at once, and the newest replaces what a receiver has not taken.
/// It counts as delivered under the same conditions as on an InProcessLink: receivers answer what they take,
/// if the sender is blocking. A receiver whose program ends holds nothing back, at the latest after the
/// second in which DDS misses it. Packages of types that a receiver has in another version are not delivered
/// to it; both programs report that once. The color table and the goal, which are sent only when the user
/// chooses others, are also sent to receivers that come later.
class SendingEnd final : public Link {
 public:
  /// `blocking` is that of the sender; `owner` must live until close() has returned.
  static Result<std::shared_ptr<SendingEnd>> open(EndSetup setup, EndOwner& owner, bool blocking);
  ~SendingEnd() override;

  void offer(PackagePtr package) override;
  bool delivered() const override { return !kept_.load(std::memory_order_acquire); }
  /// Always null: this half only sends.
  PackagePtr take() override { return nullptr; }
  void close() override;
  bool closed() const override { return !reachable_.load(std::memory_order_acquire); }
  bool ended() const override { return ended_.load(std::memory_order_acquire); }
  /// Always 0: receivers count what they missed.
  std::uint64_t missed() const override { return 0; }

  /// How many packages were written. Any thread.
  std::uint64_t written() const;
  /// How many receivers are connected, and the least that one of them has confirmed to have taken. Any
  /// thread.
  std::size_t receivers() const;
  std::uint64_t leastTaken() const;

 private:
  /// A receiver in another program.
  struct Peer {
    /// The identifier of the receiver's reader.
    Guid reader{};
    bool open = false;
    bool refused = false;
    std::uint64_t taken = 0;
    /// The number of a package that is delivered and was not taken, and of a newer one; 0: none.
    std::uint64_t slot = 0;
    std::uint64_t pending = 0;
  };

  SendingEnd(EndSetup setup, EndOwner& owner, bool blocking)
      : setup_(std::move(setup)), owner_(&owner), blocking_(blocking) {}
  Result<void> open();
  /// Called by DDS when answers have arrived, or receivers came or went.
  void takeAnswers();
  void takeAnswer(std::uint64_t from, const robotlink_wire_Package& sample, const Answer& answer);
  /// Forgets peers whose writer of answers has gone; opens those whose readers are matched. Locked.
  void followMatches();
  /// Brings the atomics up to date, and wakes the process if it waited for what has changed. Locked.
  void update();
  bool anyOpen() const;
  void writePackage(const PackagePtr& package, std::uint64_t number);

  const EndSetup setup_;
  std::mutex writeMutex_;  // held while a package is written; protects the following
  /// The last package's type and its fingerprint.
  const google::protobuf::Descriptor* type_ = nullptr;
  std::string typeName_, sender_, bytes_;
  std::uint64_t fingerprint_ = 0;
  std::mutex answersMutex_;  // held while answers are read into sample_
  Sample sample_;
  mutable std::mutex mutex_;  // protects what follows; never held while something is written
  EndOwner* owner_;           // null after close()
  const bool blocking_;
  /// The receivers, by the handles of their writers of answers.
  std::map<std::uint64_t, Peer> peers_;
  std::uint64_t number_ = 0;
  Guid guid_{};
  /// The last package, if later receivers are to get it, too, and whether such a receiver has appeared.
  PackagePtr latched_;
  bool isLatchedDue_ = false;
  // Mirrors for readers without the lock.
  std::atomic<bool> kept_{false};
  std::atomic<bool> reachable_{false};
  std::atomic<bool> ended_{false};
  // Last, so that they are deleted first, which waits for their listeners.
  Entity writer_, answers_;
};

}  // namespace robotlink::dds
