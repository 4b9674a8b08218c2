// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "robotlink/dds/EndSetup.h"
#include "robotlink/dds/Wire.h"
#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Link.h"

namespace robotlink::dds {

/// The receiving half of a link from a sender in another program. It listens to the newest sender of its
/// topic: when a program was started again, to the new one at once. Samples are parsed when the process takes
/// them, and those that it never takes are not.
///
/// A package of a type that this program has in another version, or not at all, is refused, and so are all
/// further ones of that sender.
class ReceivingEnd final : public Link {
 public:
  /// `owner` must live until close() has returned. `peer` is the sending process, for users.
  static Result<std::shared_ptr<ReceivingEnd>> open(EndSetup setup, EndOwner& owner);
  ~ReceivingEnd() override;

  /// Does nothing: this half only receives.
  void offer(PackagePtr) override {}
  bool delivered() const override { return true; }
  PackagePtr take() override;
  void close() override;
  bool closed() const override { return !reachable_.load(std::memory_order_acquire); }
  bool ended() const override { return ended_.load(std::memory_order_acquire); }
  std::uint64_t generation() const override { return generation_.load(std::memory_order_acquire); }
  std::uint64_t missed() const override { return missed_.load(std::memory_order_relaxed); }

  /// The numbers of the last packages of the sender that have arrived, and that were taken. Any thread.
  std::uint64_t arrived() const;
  std::uint64_t taken() const;

 private:
  ReceivingEnd(EndSetup setup, EndOwner& owner) : setup_(std::move(setup)), owner_(&owner) {}
  Result<void> open();
  /// Called by DDS when samples have arrived.
  void takeSamples();
  /// Whether the sample is one that this program can read; otherwise refuses the sender.
  bool accepts(const robotlink_wire_Package& sample);
  void put(std::unique_ptr<Sample>& sample);
  /// Called by DDS when senders came or went.
  void followMatches();
  /// Writes the present state to the sender.
  void answer();

  const EndSetup setup_;
  std::string receiver_;
  std::mutex samplesMutex_;  // held while samples are read into incoming_
  std::unique_ptr<Sample> incoming_ = std::make_unique<Sample>();
  /// The sender whose packages of this type were accepted.
  std::uint64_t checked_ = 0;
  std::string checkedType_;
  std::mutex answerMutex_;    // held while an answer is written, so that the newest is the last
  mutable std::mutex mutex_;  // protects what follows; never held while something is written
  EndOwner* owner_;           // null after close()
  /// The writer that it listens to, 0: none, and all that it knows.
  std::uint64_t sender_ = 0;
  Guid senderGuid_{};
  Guid guid_{};
  std::set<std::uint64_t> known_;
  bool refused_ = false;
  /// The sample that has arrived and was not taken, and one to be reused.
  std::unique_ptr<Sample> inbox_, spare_;
  std::uint64_t arrived_ = 0;
  std::uint64_t taken_ = 0;
  // Mirrors for readers without the lock.
  std::atomic<bool> filled_{false};
  std::atomic<bool> reachable_{false};
  std::atomic<bool> ended_{false};
  std::atomic<std::uint64_t> generation_{0};
  std::atomic<std::uint64_t> missed_{0};
  // Last, so that they are deleted first, which waits for their listeners.
  Entity answers_, reader_;
};

}  // namespace robotlink::dds
