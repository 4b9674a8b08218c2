// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

#include "robotlink/foxglove/protocol/ClientMessages.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"

// Every message with its fields, in one place for reading and writing: an Io is a reader, which gets messages
// to fill, or a writer, which gets const ones. Private to the codec.
namespace robotlink::websocket {

template <typename T, typename Message>
concept Is = std::same_as<std::remove_const_t<T>, Message>;
template <typename T, typename... Messages>
concept IsAny = (Is<T, Messages> || ...);

template <typename Message>
concept IsText = requires {
  Message::kOp;
};
template <typename Message>
concept IsBinary = requires {
  Message::kOpcode;
};

// JSON: field() must be there; part() may be missing; option() is left out if it is empty; sentence() is
// cut if it is too long; schema() is base64 if its encoding is binary.
void fields(auto& io, Is<ServerInfo> auto& m) {
  io.field("name", m.name);
  io.field("capabilities", m.capabilities);
  io.option("supportedEncodings", m.supportedEncodings);
  io.option("metadata", m.metadata);
  io.option("sessionId", m.sessionId);
  io.time("dataStartTime", m.dataStart);
  io.time("dataEndTime", m.dataEnd);
}
void fields(auto& io, Is<Status> auto& m) {
  io.choice("level", m.level, StatusLevel::kError);
  io.sentence("message", m.message);
  io.option("id", m.id);
}
void fields(auto& io, Is<RemoveStatus> auto& m) {
  io.field("statusIds", m.ids);
}
void fields(auto& io, IsAny<Channel, ClientChannel> auto& m) {
  io.field("id", m.id);
  io.field("topic", m.topic);
  io.field("encoding", m.encoding);
  io.field("schemaName", m.schemaName);
  io.option("schemaEncoding", m.schemaEncoding);
  io.schema(m.schemaEncoding.empty() ? m.encoding : m.schemaEncoding, m.schema);
}
void fields(auto& io, IsAny<Advertise, ClientAdvertise> auto& m) {
  io.field("channels", m.channels);
}
void fields(auto& io, IsAny<Unadvertise, ClientUnadvertise> auto& m) {
  io.field("channelIds", m.channelIds);
}
void fields(auto& io, IsAny<ParameterValues, SetParameters> auto& m) {
  io.field("parameters", m.parameters);
  io.option("id", m.id);
}
void fields(auto& io, Is<ServiceSchema> auto& m) {
  io.field("encoding", m.encoding);
  io.field("schemaName", m.schemaName);
  io.field("schemaEncoding", m.schemaEncoding);
  io.schema(m.schemaEncoding, m.schema);
}
void fields(auto& io, Is<Service> auto& m) {
  io.field("id", m.id);
  io.field("name", m.name);
  io.field("type", m.type);
  io.part("request", m.request);
  io.part("response", m.response);
}
void fields(auto& io, Is<AdvertiseServices> auto& m) {
  io.field("services", m.services);
}
void fields(auto& io, Is<UnadvertiseServices> auto& m) {
  io.field("serviceIds", m.serviceIds);
}
void fields(auto& io, Is<ServiceCallFailure> auto& m) {
  io.field("serviceId", m.serviceId);
  io.field("callId", m.callId);
  io.sentence("message", m.message);
}
void fields(auto& io, Is<ConnectionGraphUpdate> auto& m) {
  io.ids("publishedTopics", "publisherIds", m.publishedTopics);
  io.ids("subscribedTopics", "subscriberIds", m.subscribedTopics);
  io.ids("advertisedServices", "providerIds", m.advertisedServices);
  io.field("removedTopics", m.removedTopics);
  io.field("removedServices", m.removedServices);
}
void fields(auto& io, Is<Subscription> auto& m) {
  io.field("id", m.id);
  io.field("channelId", m.channelId);
}
void fields(auto& io, Is<Subscribe> auto& m) {
  io.field("subscriptions", m.subscriptions);
}
void fields(auto& io, Is<Unsubscribe> auto& m) {
  io.field("subscriptionIds", m.subscriptionIds);
}
void fields(auto& io, Is<GetParameters> auto& m) {
  io.field("parameterNames", m.names);
  io.option("id", m.id);
}
void fields(auto& io, IsAny<SubscribeParameterUpdates, UnsubscribeParameterUpdates> auto& m) {
  io.field("parameterNames", m.names);
}
void fields(auto&, Is<SubscribeConnectionGraph> auto&) {}
void fields(auto&, Is<UnsubscribeConnectionGraph> auto&) {}
void fields(auto& io, Is<FetchAsset> auto& m) {
  io.field("uri", m.uri);
  io.field("requestId", m.requestId);
}

// Binary: texts have their length before them, the rest is the payload.
void fields(auto& io, Is<MessageData> auto& m) {
  io.number(m.subscriptionId);
  io.time(m.time);
  io.rest(m.payload);
}
void fields(auto& io, Is<Time> auto& m) {
  io.time(m.time);
}
void fields(auto& io, Is<ServiceCallResponse> auto& m) {
  io.number(m.serviceId);
  io.number(m.callId);
  io.text(m.encoding);
  io.rest(m.payload);
}
void fields(auto& io, Is<FetchAssetResponse> auto& m) {
  io.number(m.requestId);
  io.outcome(m.error);
  io.rest(m.data);
}
void fields(auto& io, Is<PlaybackState> auto& m) {
  io.choice("status", m.phase, PlaybackState::Phase::kEnded);
  io.time(m.time);
  io.speed(m.speed);
  io.flag("didSeek", m.didSeek);
  io.text(m.requestId);
}
void fields(auto& io, Is<ClientMessageData> auto& m) {
  io.number(m.channelId);
  io.rest(m.payload);
}
void fields(auto& io, Is<ServiceCallRequest> auto& m) {
  io.number(m.serviceId);
  io.number(m.callId);
  io.text(m.encoding);
  io.rest(m.payload);
}
void fields(auto& io, Is<PlaybackControl> auto& m) {
  io.choice("command", m.command, PlaybackControl::Command::kPause);
  io.speed(m.speed);
  io.option("hadSeek", m.seek);
  io.text(m.requestId);
}

}  // namespace robotlink::websocket
