// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/PackageBoard.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/timestamp.pb.h>

#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/FieldValues.h"
#include "robotlink/process/Process.h"

namespace robotlink {
namespace {

using Packages = google::protobuf::RepeatedPtrField<robotcontrol::StopwatchTimes::Package>;

/// Null if packages of this type have no timestamp.
const google::protobuf::FieldDescriptor* stampOf(const google::protobuf::Message& package) {
  const auto* field = package.GetDescriptor()->FindFieldByName("timestamp");
  const bool isStamp = field != nullptr && !field->is_repeated() &&
                       field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE &&
                       isTime(*field->message_type());
  return isStamp ? field : nullptr;
}

/// Adds a package with its timestamp; returns null for a package without one.
robotcontrol::StopwatchTimes::Package* addStamped(Packages& to, const PackageBoard::Entry& entry,
                                                  const google::protobuf::Message& package) {
  const auto* field = stampOf(package);
  if (field == nullptr || !package.GetReflection()->HasField(package, field)) return nullptr;
  const auto& stamp = package.GetReflection()->GetMessage(package, field);
  auto& added = *to.Add();
  added.set_name(entry.name);
  added.mutable_timestamp()->set_seconds(wholeSeconds(stamp));
  added.mutable_timestamp()->set_nanos(nanoseconds(stamp));
  added.set_of_platform(entry.ofPlatform);
  return &added;
}

}  // namespace

PackageBoard::Watch::Watch(PackageBoard& board, robotcontrol::StopwatchTimes& times)
    : board_(board), times_(times), begin_(std::chrono::steady_clock::now()) {
  for (const auto& [name, entry] : board.entries_) {
    if (entry.receiver && entry.value) addStamped(*times.mutable_received(), entry, *entry.value);
  }
  board.watch_ = this;
}

void PackageBoard::Watch::noteSent(const Entry& entry, const PackagePtr& package) {
  if (!entry.sender || !package) return;
  auto* added = addStamped(*times_.mutable_sent(), entry, *package);
  if (added == nullptr) return;
  added->set_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count());
}

PackageBoard::Entry& PackageBoard::entry(const std::string& package) {
  Entry& entry = entries_[package];
  entry.name = package;
  return entry;
}

void PackageBoard::addReceiver(const std::string& package, Blocking blocking) {
  entry(package).receiver = std::make_unique<AnyReceiver>(process_, package, blocking);
}

void PackageBoard::addSender(const std::string& package, Blocking blocking) {
  Entry& yielded = entry(package);
  if (!yielded.sender) yielded.sender = std::make_unique<AnySender>(process_, package, blocking);
}

void PackageBoard::beginFrame() {
  for (auto& [name, entry] : entries_) {
    if (entry.receiver) receive(entry);
  }
}

void PackageBoard::receive(Entry& entry) {
  if (entry.once) {
    put(entry, replaced(entry, nullptr));
  } else if (entry.receiver->isNew()) {
    put(entry, replaced(entry, entry.receiver->value()));
  } else if (entry.restored) {
    put(entry, entry.restored);
  }
  entry.restored = nullptr;
}

void PackageBoard::endFrame() {
  for (auto& [name, entry] : entries_) {
    // A log has each package once.
    if (std::exchange(entry.isAwaited, false) && entry.value && !entry.recorded) publish(entry);
    if (!entry.sender) continue;
    if (entry.once) {
      pass(entry, replaced(entry, nullptr));
    } else if (entry.restored) {
      pass(entry, entry.restored);
    }
    entry.restored = nullptr;
  }
}

void PackageBoard::send(Entry& entry, const PackagePtr& package) {
  if (entry.held) entry.offered = package;
  pass(entry, replaced(entry, package));
  entry.restored = nullptr;
}

void PackageBoard::pass(Entry& entry, const PackagePtr& package) {
  if (watch_ != nullptr) watch_->noteSent(entry, package);
  put(entry, package);
  if (entry.sender) entry.sender->send(package);
}

PackagePtr PackageBoard::replaced(Entry& entry, const PackagePtr& package) {
  if (entry.once) return stamped(std::exchange(entry.once, nullptr));
  return entry.held ? stamped(entry.held) : package;
}

/// Readers drop packages that seem old, so a value without a timestamp gets that of the frame.
PackagePtr PackageBoard::stamped(PackagePtr value) const {
  const auto* field = stampOf(*value);
  if (field == nullptr) return value;
  const auto& stamp = value->GetReflection()->GetMessage(*value, field);
  if (wholeSeconds(stamp) != 0 || nanoseconds(stamp) != 0) return value;
  const std::shared_ptr<google::protobuf::Message> copy(value->New());
  copy->CopyFrom(*value);
  auto* now =
      dynamic_cast<google::protobuf::Timestamp*>(copy->GetReflection()->MutableMessage(copy.get(), field));
  if (now != nullptr) assign(*now, process_.frameTime());
  return copy;
}

bool PackageBoard::isSettable(const std::string& package) const {
  const auto found = entries_.find(package);
  return found != entries_.end() && found->second.settable;
}

PackageBoard::Entry* PackageBoard::settable(const std::string& package) {
  const auto found = entries_.find(package);
  return found == entries_.end() || !found->second.settable ? nullptr : &found->second;
}

void PackageBoard::setOnce(const std::string& package, PackagePtr value) {
  if (Entry* entry = settable(package)) entry->once = std::move(value);
}

void PackageBoard::hold(const std::string& package, PackagePtr value) {
  Entry* entry = settable(package);
  if (entry == nullptr) return;
  if (!entry->held) entry->offered = entry->sender ? entry->value : nullptr;
  entry->once = entry->held = std::move(value);
  entry->restored = nullptr;
  if (entry->sender) entry->sender->setHeld(true);
  if (entry->receiver) entry->receiver->setHeld(true);
}

void PackageBoard::release(const std::string& package) {
  Entry* entry = settable(package);
  if (entry == nullptr || !std::exchange(entry->held, nullptr)) return;
  entry->once = nullptr;
  entry->restored = std::exchange(entry->offered, nullptr);
  if (!entry->sender && entry->receiver) entry->restored = entry->receiver->value();
  if (entry->sender) entry->sender->setHeld(false);
  if (entry->receiver) entry->receiver->setHeld(false);
}

void PackageBoard::put(Entry& entry, PackagePtr package) {
  entry.value = std::move(package);
  ++entry.arrivals;
  publish(entry);
}

void PackageBoard::publish(Entry& entry) {
  entry.isAwaited = false;
  const bool asked = askedFor(entry);
  if (asked || entry.recorded) debug_.package(entry.name, entry.value).onlyRecorded = !asked;
}

bool PackageBoard::askedFor(Entry& entry) {
  if (entry.mode.mode().kind() == robotcontrol::KeyMode::OFF || !entry.mode.due(process_.frameTime()))
    return false;
  if (entry.mode.mode().kind() == robotcontrol::KeyMode::OFF) modeChanged_ = true;
  return true;
}

bool PackageBoard::show(const std::string& package, const robotcontrol::KeyMode& mode) {
  const auto found = entries_.find(package);
  if (found == entries_.end() || !found->second.shown) return false;
  found->second.mode.set(mode);
  // Modes that count packages wait for the next one.
  found->second.isAwaited =
      mode.kind() == robotcontrol::KeyMode::ALWAYS || mode.kind() == robotcontrol::KeyMode::EVERY_MS;
  return true;
}

void PackageBoard::record(const std::set<std::string>& packages) {
  for (auto& [name, entry] : entries_) entry.recorded = entry.shown && packages.contains(name);
}

std::vector<const PackageBoard::Entry*> PackageBoard::shown() const {
  std::vector<const Entry*> result;
  for (const auto& [name, entry] : entries_) {
    if (entry.shown) result.push_back(&entry);
  }
  return result;
}

bool PackageBoard::takeModeChange() {
  return std::exchange(modeChanged_, false);
}

}  // namespace robotlink
