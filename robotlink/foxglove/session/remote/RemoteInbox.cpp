// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/RemoteInbox.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "robotlink/session/LatchedMessages.h"

namespace robotlink::websocket {
namespace {

/// The memory in addition to the contents: the package, and its place in the queue.
constexpr std::size_t kArrivalBytes = 256;

/// The name of the stream is not known here; tables are latched by their type.
bool isKept(const RemoteInbox::Arrival& arrival) {
  if (arrival.isSparable) return false;
  return !arrival.value || isLatched(arrival.channel->topic, arrival.value->GetDescriptor()->full_name());
}

/// The encoding of schemas for one of messages, where a server does not say which.
std::string impliedSchema(const std::string& encoding) {
  if (encoding == "json") return "jsonschema";
  if (encoding == "cdr") return "ros2msg";
  return encoding == "ros1" ? "ros1msg" : encoding;
}

bool isDecodable(const std::string& encoding) {
  constexpr std::array<std::string_view, 4> kDecoded{"cdr", "json", "protobuf", "ros1"};
  return std::ranges::find(kDecoded, encoding) != kDecoded.end();
}

}  // namespace

RemoteChannel::RemoteChannel(const Channel& channel)
    : id(channel.id),
      topic(channel.topic),
      type(MessageType::expectedName(channel.schemaName, channel.encoding)),
      encoding(channel.encoding),
      isDecoded(isDecodable(encoding)) {}

bool RemoteChannel::isHeavy() const {
  constexpr const char* kHeavy[] = {"Image", "Video", "PointCloud", "Grid", "Mesh"};
  return std::ranges::any_of(kHeavy,
                             [this](const char* part) { return type.find(part) != std::string::npos; }) &&
         type.find("Annotation") == std::string::npos;
}

std::vector<RemoteChannelPtr> RemoteInbox::add(const std::vector<Channel>& channels) {
  std::vector<RemoteChannelPtr> added;
  for (const Channel& channel : channels) {
    added.push_back(std::make_shared<RemoteChannel>(channel));
    const std::string& schema = channel.schemaEncoding;
    types_.insert_or_assign(channel.id, Typed{added.back(),
                                              channel.schemaName,
                                              channel.schema,
                                              schema.empty() ? impliedSchema(channel.encoding) : schema,
                                              {}});
  }
  return added;
}

void RemoteInbox::remove(const std::vector<Channel>& channels) {
  for (const Channel& channel : channels) types_.erase(channel.id);
}

PackagePtr RemoteInbox::decode(Typed& typed, std::string_view payload) const {
  const RemoteChannel& channel = *typed.channel;
  if (!typed.type) {
    const MessageSchema schema{typed.schemaName, typed.schemaEncoding, typed.schema};
    const bool hasSchema = !typed.schema.empty() || !typed.schemaName.empty();
    typed.type.emplace(hasSchema ? &schema : nullptr, channel.encoding, [&] { return std::string(payload); });
    typed.schema = {};
    if (!typed.type->isDecoded()) typed.channel->isDecoded = false;
  }
  auto value = typed.type->read({reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size()});
  return value && convert_ ? convert_(value) : value;
}

void RemoteInbox::push(const Channel& channel, Instant time, std::string_view payload) {
  const auto found = types_.find(channel.id);
  if (found == types_.end()) return;
  const RemoteChannelPtr& known = found->second.channel;
  ++known->messages;
  known->bytes += payload.size();
  // A message is skipped if another channel of its topic is used.
  if (!known->isDecoded && !found->second.type) return;
  if (PackagePtr value = decode(found->second, payload))
    push({known, time, std::move(value), payload.size() + kArrivalBytes, {}});
  else
    ++dropped_;
}

void RemoteInbox::push(std::function<void()> work) {
  push(Arrival{nullptr, {}, nullptr, 0, std::move(work)});
}

bool RemoteInbox::pushChange(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    if (changes_ >= limits_.changes) return false;
    ++changes_;
  }
  push(Arrival{nullptr, {}, nullptr, 0, std::move(work)});
  return true;
}

void RemoteInbox::pushSparable(std::function<void()> work, std::size_t bytes) {
  push(Arrival{nullptr, {}, nullptr, bytes + kArrivalBytes, std::move(work), true});
}

void RemoteInbox::push(Arrival arrival) {
  const std::lock_guard lock(mutex_);
  messages_ += arrival.isCounted() ? 1 : 0;
  bytes_ += arrival.bytes;
  arrivals_.push_back(std::move(arrival));
  while (messages_ > limits_.messages || bytes_ > limits_.bytes) {
    auto oldest = std::ranges::find_if(arrivals_, [](const Arrival& one) { return !isKept(one); });
    if (oldest == arrivals_.end())
      oldest = std::ranges::find_if(arrivals_, [](const Arrival& one) { return one.isCounted(); });
    --messages_;
    bytes_ -= oldest->bytes;
    ++dropped_;
    arrivals_.erase(oldest);
  }
}

std::deque<RemoteInbox::Arrival> RemoteInbox::take() {
  const std::lock_guard lock(mutex_);
  messages_ = bytes_ = changes_ = 0;
  return std::exchange(arrivals_, {});
}

}  // namespace robotlink::websocket
