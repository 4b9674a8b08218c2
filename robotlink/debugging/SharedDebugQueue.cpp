// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/SharedDebugQueue.h"

#include <limits>
#include <map>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/ParsedMessage.h"

namespace robotlink {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using robotcontrol::DebugMessage;
using robotcontrol::DebugQueue;

namespace {

/// The fields of DebugMessage that hold contents, by their types.
const std::map<const Descriptor*, const FieldDescriptor*>& contentFields() {
  // Never destroyed: debug processes run on while another one calls exit().
  static const auto* const kFields = [] {
    auto* fields = new std::map<const Descriptor*, const FieldDescriptor*>;
    const auto* content = DebugMessage::descriptor()->FindOneofByName("content");
    for (int i = 0; i < content->field_count(); ++i)
      fields->emplace(content->field(i)->message_type(), content->field(i));
    return fields;
  }();
  return *kFields;
}

void setContent(DebugMessage& to, const Message& content) {
  const auto field = contentFields().find(content.GetDescriptor());
  if (field != contentFields().end()) {
    to.GetReflection()->MutableMessage(&to, field->second)->CopyFrom(content);
    return;
  }
  to.mutable_package()->set_type(content.GetDescriptor()->full_name());
  content.SerializeToString(to.mutable_package()->mutable_data());
}

/// Empty unless the time fits into an instant, with room for the sum of two.
std::optional<Instant> timeOf(const DebugMessage& message) {
  constexpr std::int64_t kMaxSeconds = std::numeric_limits<std::int64_t>::max() / 2 / 1'000'000'000 - 10;
  if (!message.has_timestamp()) return std::nullopt;
  const auto& stamp = message.timestamp();
  if (stamp.seconds() > kMaxSeconds || stamp.seconds() < -kMaxSeconds) return std::nullopt;
  if (stamp.nanos() < 0 || stamp.nanos() >= 1'000'000'000) return std::nullopt;
  return instant(stamp);
}

PackagePtr takeContent(DebugMessage& from) {
  if (from.has_package()) {
    if (PackagePtr package = parsedMessage(from.package().type(), from.package().data())) return package;
  }
  const auto* content = DebugMessage::descriptor()->FindOneofByName("content");
  const FieldDescriptor* field = from.GetReflection()->GetOneofFieldDescriptor(from, content);
  return field == nullptr ? nullptr : PackagePtr(from.GetReflection()->ReleaseMessage(&from, field));
}

/// Keeps a queue together with the package that represents it: std::get_deleter() finds it again.
struct Companion {
  std::shared_ptr<const SharedDebugQueue> queue;
  void operator()(const DebugQueue* package) const { delete package; }
};

void assignHead(DebugQueue& to, const SharedDebugQueue& from) {
  to.set_process(from.process);
  to.set_dropped(from.dropped);
  to.set_number(from.number);
  to.set_requests_done(from.requestsDone);
  to.set_request_done(from.requestDone);
}

}  // namespace

DebugQueue toWire(const SharedDebugQueue& queue) {
  DebugQueue result;
  assignHead(result, queue);
  for (const SharedDebugMessage& message : queue.messages) {
    DebugMessage& added = *result.add_messages();
    added.set_path(message.path);
    if (message.time) assign(*added.mutable_timestamp(), *message.time);
    if (message.content) setContent(added, *message.content);
    added.set_only_recorded(message.onlyRecorded);
  }
  return result;
}

std::shared_ptr<const SharedDebugQueue> fromWire(DebugQueue queue) {
  const auto result = std::make_shared<SharedDebugQueue>();
  result->process = queue.process();
  result->dropped = queue.dropped();
  result->number = queue.number();
  result->requestsDone = queue.requests_done();
  result->requestDone = queue.request_done();
  result->messages.reserve(static_cast<std::size_t>(queue.messages_size()));
  for (DebugMessage& message : *queue.mutable_messages()) {
    const auto time = timeOf(message);
    const bool onlyRecorded = message.only_recorded();
    PackagePtr content = takeContent(message);
    result->messages.push_back({std::move(*message.mutable_path()), time, std::move(content), onlyRecorded});
  }
  return result;
}

PackagePtr packageOf(std::shared_ptr<const SharedDebugQueue> queue) {
  auto package = std::make_unique<DebugQueue>();
  assignHead(*package, *queue);
  return std::shared_ptr<const DebugQueue>(package.release(), Companion{std::move(queue)});
}

std::shared_ptr<const SharedDebugQueue> queueIn(const PackagePtr& package) {
  if (const auto* companion = std::get_deleter<Companion>(package)) return companion->queue;
  const auto* queue = dynamic_cast<const DebugQueue*>(package.get());
  return queue == nullptr ? nullptr : fromWire(*queue);
}

PackagePtr wireForm(const PackagePtr& package) {
  const auto* companion = std::get_deleter<Companion>(package);
  return companion == nullptr ? package : std::make_shared<DebugQueue>(toWire(*companion->queue));
}

}  // namespace robotlink
