// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/SendingEnd.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Packages.h"

namespace robotlink::dds {
namespace {

constexpr std::uint32_t kMaxMatches = 64;

/// Whether a package holds until the next one, because it is sent only when the user chooses something else.
bool isLatched(const std::string& package) {
  return package == kColorTable.name || package == kMotionTexts.name || package == kDriveGoal.name;
}

/// The readers that a writer is matched with.
std::vector<Guid> readersOf(dds_entity_t writer) {
  std::vector<Guid> result;
  dds_instance_handle_t handles[kMaxMatches];
  const auto count = dds_get_matched_subscriptions(writer, handles, kMaxMatches);
  for (std::int32_t i = 0; i < std::min<std::int32_t>(count, kMaxMatches); ++i) {
    auto* reader = dds_get_matched_subscription_data(writer, handles[i]);
    if (reader == nullptr) continue;
    Guid& guid = result.emplace_back();
    std::copy_n(reader->key.v, guid.size(), guid.begin());
    dds_builtintopic_free_endpoint(reader);
  }
  return result;
}

}  // namespace

Result<std::shared_ptr<SendingEnd>> SendingEnd::open(EndSetup setup, EndOwner& owner, bool blocking) {
  std::shared_ptr<SendingEnd> end(new SendingEnd(std::move(setup), owner, blocking));
  if (auto opened = end->open(); !opened) return tl::unexpected(opened.error());
  return end;
}

Result<void> SendingEnd::open() {
  sender_ = setup_.program + "/" + setup_.process;
  const dds_entity_t participant = setup_.node->participant();
  auto writer = openWriter(participant, setup_.topic, History::kNewest);
  if (!writer) return tl::unexpected(writer.error());
  auto answers = openReader(participant, setup_.topic + "/answers", History::kLatched);
  if (!answers) return tl::unexpected(answers.error());
  writer_ = std::move(*writer);
  answers_ = std::move(*answers);
  guid_ = guidOf(writer_.get());
  const std::unique_ptr<dds_listener_t, void (*)(dds_listener_t*)> listener(dds_create_listener(this),
                                                                            &dds_delete_listener);
  dds_lset_publication_matched(listener.get(),
                               [](dds_entity_t, dds_publication_matched_status_t, void* self) {
                                 static_cast<SendingEnd*>(self)->takeAnswers();
                               });
  dds_set_listener(writer_.get(), listener.get());
  dds_reset_listener(listener.get());
  dds_lset_data_available(listener.get(),
                          [](dds_entity_t, void* self) { static_cast<SendingEnd*>(self)->takeAnswers(); });
  dds_lset_subscription_matched(listener.get(),
                                [](dds_entity_t, dds_subscription_matched_status_t, void* self) {
                                  static_cast<SendingEnd*>(self)->takeAnswers();
                                });
  dds_set_listener(answers_.get(), listener.get());
  takeAnswers();  // the answers that arrived before there were listeners
  return {};
}

SendingEnd::~SendingEnd() {
  close();
}

void SendingEnd::offer(PackagePtr package) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (isLatched(setup_.package)) latched_ = package;
    if (owner_ == nullptr || !anyOpen()) return;
    number = ++number_;
    for (auto& [handle, peer] : peers_) {
      if (peer.open) (peer.slot == 0 ? peer.slot : peer.pending) = number;
    }
    update();
  }
  writePackage(package, number);
}

void SendingEnd::writePackage(const PackagePtr& package, std::uint64_t number) {
  const std::lock_guard writing(writeMutex_);
  const PackagePtr wire = wireForm(package);
  if (wire->GetDescriptor() != type_) {
    type_ = wire->GetDescriptor();
    typeName_ = type_->full_name();
    fingerprint_ = setup_.fingerprint(*type_);
  }
  bytes_.clear();
  wire->AppendToString(&bytes_);
  // If the line is full, the next package replaces this one.
  write(writer_.get(), {.name = setup_.package,
                        .type = typeName_,
                        .sender = sender_,
                        .fingerprint = fingerprint_,
                        .number = number,
                        .time = setup_.clock->now().time_since_epoch().count(),
                        .kind = static_cast<std::uint8_t>(blocking_ ? 1 : 0),
                        .data = bytes_.data(),
                        .size = bytes_.size()});
}

void SendingEnd::close() {
  {
    const std::lock_guard lock(mutex_);
    if (owner_ == nullptr) return;
    owner_->wake();  // The owner may have been waiting for a receiver.
    owner_ = nullptr;
    peers_.clear();
    update();
    ended_.store(true, std::memory_order_release);
  }
  // The listener of each uses both.
  answers_.silence();
  writer_.silence();
  answers_.reset();
  writer_.reset();
}

void SendingEnd::takeAnswers() {
  const std::lock_guard reading(answersMutex_);
  const dds_entity_t answers = answers_.get();
  while (const auto from = dds::take(answers, sample_)) {
    if (const auto answer = answerIn(sample_.package)) takeAnswer(*from, sample_.package, *answer);
  }
  PackagePtr late;
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (owner_ == nullptr) return;
    followMatches();
    update();
    if (std::exchange(isLatchedDue_, false) && latched_) {
      late = latched_;
      number = ++number_;
    }
  }
  if (late) writePackage(late, number);
}

void SendingEnd::takeAnswer(std::uint64_t from, const robotlink_wire_Package& sample, const Answer& answer) {
  bool isRefused = false;
  {
    const std::lock_guard lock(mutex_);
    if (owner_ == nullptr) return;
    Peer& peer = peers_[from];
    if (answer.writer != guid_ || answer.state == Answer::State::kClosed) {
      peer = {};
      return;
    }
    peer.reader = answer.reader;
    if (answer.state == Answer::State::kRefused) {
      isRefused = !peer.refused;
      peer = {.refused = true};
    } else if (answer.taken >= peer.taken) {
      peer.taken = answer.taken;
      if (peer.taken >= peer.slot) {
        // If it took only the first, it is ready for the second, which is there already.
        peer.slot = peer.pending > peer.taken ? peer.pending : 0;
        peer.pending = 0;
      }
    }
  }
  if (!isRefused) return;
  const std::string receiver = sample.sender != nullptr ? sample.sender : "";
  setup_.report(
      "Program " + receiver.substr(0, receiver.find('/')) + " refuses " + setup_.package + " of program " +
      setup_.program +
      ": the two were built from different versions of this package. Build both from the same sources.");
}

void SendingEnd::followMatches() {
  dds_instance_handle_t handles[kMaxMatches];
  const auto count =
      std::min<std::int32_t>(dds_get_matched_publications(answers_.get(), handles, kMaxMatches), kMaxMatches);
  std::erase_if(peers_, [&](const auto& peer) {
    return count >= 0 && std::find(handles, handles + count, peer.first) == handles + count;
  });
  const std::vector<Guid> readers = readersOf(writer_.get());
  for (auto& [handle, peer] : peers_) {
    const bool isMatched = std::find(readers.begin(), readers.end(), peer.reader) != readers.end();
    if (isMatched && !peer.refused && !std::exchange(peer.open, true)) isLatchedDue_ = true;
    if (!isMatched && peer.open) peer = {.reader = peer.reader};
  }
}

bool SendingEnd::anyOpen() const {
  return std::any_of(peers_.begin(), peers_.end(), [](const auto& peer) { return peer.second.open; });
}

void SendingEnd::update() {
  const bool kept =
      std::any_of(peers_.begin(), peers_.end(), [](const auto& peer) { return peer.second.pending != 0; });
  const bool wasKept = kept_.exchange(blocking_ && kept, std::memory_order_acq_rel);
  reachable_.store(owner_ != nullptr && anyOpen(), std::memory_order_release);
  if (wasKept && !kept && owner_ != nullptr) owner_->wake();
}

std::uint64_t SendingEnd::written() const {
  const std::lock_guard lock(mutex_);
  return number_;
}

std::size_t SendingEnd::receivers() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(peers_.begin(), peers_.end(), [](const auto& peer) { return peer.second.open; }));
}

std::uint64_t SendingEnd::leastTaken() const {
  const std::lock_guard lock(mutex_);
  std::uint64_t least = number_;
  for (const auto& [handle, peer] : peers_) {
    if (peer.open) least = std::min(least, peer.taken);
  }
  return least;
}

}  // namespace robotlink::dds
