// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "robotlink/base/Clock.h"
#include "robotlink/foxglove/protocol/Value.h"

// The messages from a client to a server: JSON if the message has a kOp, else binary. Members of type
// std::string_view are parts of the frame that was decoded, or of what the caller keeps until the message is
// encoded.
namespace robotlink::websocket {

struct Subscription {
  /// Chosen by the client.
  std::uint32_t id = 0;
  std::uint64_t channelId = 0;
  bool operator==(const Subscription&) const = default;
};
struct Subscribe {
  static constexpr char kOp[] = "subscribe";
  std::vector<Subscription> subscriptions;
  bool operator==(const Subscribe&) const = default;
};
struct Unsubscribe {
  static constexpr char kOp[] = "unsubscribe";
  std::vector<std::uint32_t> subscriptionIds;
  bool operator==(const Unsubscribe&) const = default;
};

/// A stream that the client publishes.
struct ClientChannel {
  /// Chosen by the client.
  std::uint32_t id = 0;
  std::string topic, encoding, schemaName, schema, schemaEncoding;
  bool operator==(const ClientChannel&) const = default;
};
struct ClientAdvertise {
  static constexpr char kOp[] = "advertise";
  std::vector<ClientChannel> channels;
  bool operator==(const ClientAdvertise&) const = default;
};
struct ClientUnadvertise {
  static constexpr char kOp[] = "unadvertise";
  std::vector<std::uint32_t> channelIds;
  bool operator==(const ClientUnadvertise&) const = default;
};

struct GetParameters {
  static constexpr char kOp[] = "getParameters";
  /// Empty: all.
  std::vector<std::string> names;
  std::string id;
  bool operator==(const GetParameters&) const = default;
};
struct SetParameters {
  static constexpr char kOp[] = "setParameters";
  std::vector<Parameter> parameters;
  /// If it is empty, nothing is answered.
  std::string id;
  bool operator==(const SetParameters&) const = default;
};
struct SubscribeParameterUpdates {
  static constexpr char kOp[] = "subscribeParameterUpdates";
  /// Empty: all.
  std::vector<std::string> names;
  bool operator==(const SubscribeParameterUpdates&) const = default;
};
struct UnsubscribeParameterUpdates {
  static constexpr char kOp[] = "unsubscribeParameterUpdates";
  /// Empty: all.
  std::vector<std::string> names;
  bool operator==(const UnsubscribeParameterUpdates&) const = default;
};

struct SubscribeConnectionGraph {
  static constexpr char kOp[] = "subscribeConnectionGraph";
  bool operator==(const SubscribeConnectionGraph&) const = default;
};
struct UnsubscribeConnectionGraph {
  static constexpr char kOp[] = "unsubscribeConnectionGraph";
  bool operator==(const UnsubscribeConnectionGraph&) const = default;
};

struct FetchAsset {
  static constexpr char kOp[] = "fetchAsset";
  std::string uri;
  std::uint32_t requestId = 0;
  bool operator==(const FetchAsset&) const = default;
};

struct ClientMessageData {
  static constexpr std::uint8_t kOpcode = 1;
  std::uint32_t channelId = 0;
  std::string_view payload;
  bool operator==(const ClientMessageData&) const = default;
};
struct ServiceCallRequest {
  static constexpr std::uint8_t kOpcode = 2;
  std::uint32_t serviceId = 0, callId = 0;
  std::string encoding;
  std::string_view payload;
  bool operator==(const ServiceCallRequest&) const = default;
};

struct PlaybackControl {
  static constexpr std::uint8_t kOpcode = 3;
  enum class Command : std::uint8_t { kPlay, kPause };
  Command command = Command::kPlay;
  float speed = 1;
  std::optional<Instant> seek;
  std::string requestId;
  bool operator==(const PlaybackControl&) const = default;
};

using ClientMessage = std::variant<Subscribe, Unsubscribe, ClientAdvertise, ClientUnadvertise, GetParameters,
                                   SetParameters, SubscribeParameterUpdates, UnsubscribeParameterUpdates,
                                   SubscribeConnectionGraph, UnsubscribeConnectionGraph, FetchAsset,
                                   ClientMessageData, ServiceCallRequest, PlaybackControl>;

}  // namespace robotlink::websocket
