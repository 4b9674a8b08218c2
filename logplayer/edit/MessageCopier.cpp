// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/MessageCopier.h"

#include <google/protobuf/message.h>

#include <memory>
#include <string>

namespace logplayer {

using robotlink::Result;

Result<const MessageCopier::Target*> MessageCopier::targetOf(std::uint16_t channel) {
  if (const auto known = targets_.find(channel); known != targets_.end()) return &known->second;
  const mcap::Channel& origin = from_.channels().at(channel);
  const auto schema = from_.schemas().find(origin.schemaId);
  Target target;
  std::uint16_t schemaId = 0;
  if (origin.messageEncoding != "protobuf" && !change_.isNothing()) {
    foreign_ += (foreign_.empty() ? "" : ", ") + origin.topic;
  }
  if (schema != from_.schemas().end()) {
    const auto id = to_.addSchema(schema->second.name, schema->second.encoding, schema->second.data);
    if (!id) return tl::unexpected(id.error());
    schemaId = *id;
    const mcap::Schema& known = schema->second;
    const robotlink::MessageSchema described{known.name, known.encoding, known.data};
    robotlink::MessageType type(&described, origin.messageEncoding);
    const auto empty = type.encoding() == "protobuf" ? type.read({}) : nullptr;
    if (empty && change_.concerns(*empty->GetDescriptor())) target.type = std::move(type);
  }
  const auto id =
      to_.addChannel(change_.renamed(origin.topic), schemaId, origin.messageEncoding, origin.metadata);
  if (!id) return tl::unexpected(id.error());
  target.channel = *id;
  return &targets_.emplace(channel, std::move(target)).first->second;
}

Result<void> MessageCopier::copy(const mcap::Message& message) {
  const auto target = targetOf(message.channelId);
  if (!target) return tl::unexpected(target.error());
  mcap::Message copy = message;
  copy.channelId = (*target)->channel;
  copy.logTime += offset_;
  copy.publishTime += offset_;
  if (!(*target)->type) return to_.write(copy);
  const auto value = (*target)->type->read(message.data);
  if (!value) {
    ++unchanged_;
    return to_.write(copy);
  }
  const std::unique_ptr<google::protobuf::Message> changed(value->New());
  changed->CopyFrom(*value);
  change_.apply(*changed);
  const std::string data = changed->SerializeAsString();
  copy.data = {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()};
  return to_.write(copy);
}

}  // namespace logplayer
