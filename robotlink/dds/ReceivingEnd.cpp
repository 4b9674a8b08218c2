// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/ReceivingEnd.h"

#include <google/protobuf/message.h>

#include <algorithm>

#include "robotlink/packages/PackageTypes.h"
#include "robotlink/packages/ParsedMessage.h"

namespace robotlink::dds {
namespace {

namespace pb = google::protobuf;

constexpr std::uint32_t kMaxSenders = 64;

Guid publisherOf(dds_entity_t reader, std::uint64_t handle) {
  Guid result{};
  auto* writer = dds_get_matched_publication_data(reader, handle);
  if (writer == nullptr) return result;
  std::copy_n(writer->key.v, result.size(), result.begin());
  dds_builtintopic_free_endpoint(writer);
  return result;
}

const pb::Descriptor* typeOf(const robotlink_wire_Package& sample) {
  return sample.type == nullptr ? nullptr
                                : pb::DescriptorPool::generated_pool()->FindMessageTypeByName(sample.type);
}

PackagePtr parsed(const robotlink_wire_Package& sample) {
  if (sample.type == nullptr) return nullptr;
  return parsedMessage(sample.type,
                       {reinterpret_cast<const char*>(sample.data._buffer), sample.data._length});
}

}  // namespace

Result<std::shared_ptr<ReceivingEnd>> ReceivingEnd::open(EndSetup setup, EndOwner& owner) {
  std::shared_ptr<ReceivingEnd> end(new ReceivingEnd(std::move(setup), owner));
  if (auto opened = end->open(); !opened) return tl::unexpected(opened.error());
  return end;
}

Result<void> ReceivingEnd::open() {
  receiver_ = setup_.program + "/" + setup_.process;
  const dds_entity_t participant = setup_.node->participant();
  auto answers = openWriter(participant, setup_.topic + "/answers", History::kLatched);
  if (!answers) return tl::unexpected(answers.error());
  auto reader = openReader(participant, setup_.topic, History::kNewest);
  if (!reader) return tl::unexpected(reader.error());
  answers_ = std::move(*answers);
  reader_ = std::move(*reader);
  guid_ = guidOf(reader_.get());
  const std::unique_ptr<dds_listener_t, void (*)(dds_listener_t*)> listener(dds_create_listener(this),
                                                                            &dds_delete_listener);
  dds_lset_data_available(listener.get(),
                          [](dds_entity_t, void* self) { static_cast<ReceivingEnd*>(self)->takeSamples(); });
  dds_lset_subscription_matched(listener.get(),
                                [](dds_entity_t, dds_subscription_matched_status_t, void* self) {
                                  static_cast<ReceivingEnd*>(self)->followMatches();
                                });
  dds_set_listener(reader_.get(), listener.get());
  followMatches();  // the matches made before there was a listener
  return {};
}

ReceivingEnd::~ReceivingEnd() {
  close();
}

PackagePtr ReceivingEnd::take() {
  if (!filled_.load(std::memory_order_acquire)) return nullptr;
  std::unique_ptr<Sample> sample;
  bool isAnswered = false;
  {
    const std::lock_guard lock(mutex_);
    if (!inbox_) return nullptr;
    sample = std::move(inbox_);
    filled_.store(false, std::memory_order_release);
    taken_ = sample->package.number;
    isAnswered = owner_ != nullptr && sample->package.kind != 0;
  }
  if (isAnswered) answer();
  PackagePtr package = parsed(sample->package);
  const std::lock_guard lock(mutex_);
  spare_ = std::move(sample);
  return package;
}

void ReceivingEnd::close() {
  {
    const std::lock_guard lock(mutex_);
    if (owner_ == nullptr) return;
    owner_ = nullptr;
    reachable_.store(false, std::memory_order_release);
    ended_.store(true, std::memory_order_release);
  }
  answer();
  reader_.reset();
  answers_.reset();
}

void ReceivingEnd::takeSamples() {
  const std::lock_guard reading(samplesMutex_);
  while (const auto from = dds::take(reader_.get(), *incoming_)) {
    bool isNew = false;
    {
      const std::lock_guard lock(mutex_);
      isNew = *from != sender_;
      if (isNew && known_.contains(*from)) continue;  // a sender that was replaced
    }
    // A sample may come before the notice that its sender is there.
    if (isNew) followMatches();
    {
      const std::lock_guard lock(mutex_);
      if (*from != sender_ || refused_ || owner_ == nullptr) continue;
    }
    const char* type = incoming_->package.type;
    const bool isChecked = checked_ == *from && type != nullptr && type == checkedType_;
    if (!isChecked && !accepts(incoming_->package)) continue;
    checked_ = *from;
    checkedType_ = type;
    put(incoming_);
  }
}

bool ReceivingEnd::accepts(const robotlink_wire_Package& sample) {
  const pb::Descriptor* type = typeOf(sample);
  const pb::Descriptor* expected = typeOfPackage(setup_.package);
  const bool isRightType = type != nullptr && (expected == nullptr || type == expected);
  if (isRightType && setup_.fingerprint(*type) == sample.fingerprint) return true;
  {
    const std::lock_guard lock(mutex_);
    refused_ = true;
    reachable_.store(false, std::memory_order_release);
  }
  answer();
  const std::string sender = sample.sender != nullptr ? sample.sender : "";
  setup_.report(
      "Program " + setup_.program + " refuses " + setup_.package + " of program " +
      sender.substr(0, sender.find('/')) +
      ": the two were built from different versions of this package. Build both from the same sources.");
  return false;
}

void ReceivingEnd::put(std::unique_ptr<Sample>& sample) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t number = sample->package.number;
  if (owner_ == nullptr || number <= arrived_) return;  // a newer one was faster
  // Packages that were written since the last arrival were replaced on their way.
  const std::uint64_t lost = arrived_ != 0 ? number - arrived_ - 1 : 0;
  missed_.fetch_add(lost + (inbox_ ? 1 : 0), std::memory_order_relaxed);
  arrived_ = number;
  std::unique_ptr<Sample> next = inbox_ ? std::move(inbox_) : std::move(spare_);
  inbox_ = std::move(sample);
  sample = next ? std::move(next) : std::make_unique<Sample>();
  filled_.store(true, std::memory_order_release);
  owner_->wake();
}

void ReceivingEnd::followMatches() {
  dds_instance_handle_t handles[kMaxSenders];
  const auto count = dds_get_matched_publications(reader_.get(), handles, kMaxSenders);
  if (count < 0) return;
  const std::set<std::uint64_t> present(handles, handles + std::min<std::int32_t>(count, kMaxSenders));
  {
    const std::lock_guard lock(mutex_);
    if (owner_ == nullptr || present == known_) return;
    for (const std::uint64_t handle : present) {
      if (known_.contains(handle)) continue;
      sender_ = handle;
      senderGuid_ = publisherOf(reader_.get(), handle);
      generation_.fetch_add(1, std::memory_order_release);
      arrived_ = taken_ = 0;
      refused_ = false;
    }
    known_ = present;
    if (!present.contains(sender_)) sender_ = 0;
    reachable_.store(sender_ != 0 && !refused_, std::memory_order_release);
    owner_->wake();
  }
  answer();
}

void ReceivingEnd::answer() {
  const std::lock_guard writing(answerMutex_);
  Answer state;
  {
    const std::lock_guard lock(mutex_);
    state = {.state = owner_ == nullptr ? Answer::State::kClosed
                      : refused_        ? Answer::State::kRefused
                                        : Answer::State::kOpen,
             .writer = senderGuid_,
             .reader = guid_,
             .taken = taken_};
  }
  writeAnswer(answers_.get(), setup_.package, receiver_, state);
}

std::uint64_t ReceivingEnd::arrived() const {
  const std::lock_guard lock(mutex_);
  return arrived_;
}

std::uint64_t ReceivingEnd::taken() const {
  const std::lock_guard lock(mutex_);
  return taken_;
}

}  // namespace robotlink::dds
