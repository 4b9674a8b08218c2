// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "robotlink/base/Clock.h"
#include "robotlink/foxglove/protocol/Value.h"

// The messages from a server to a client: JSON if the message has a kOp, else binary. Schemas are bytes as
// they are, also where the wire has base64. Members of type std::string_view are parts of the frame that was
// decoded, or of what the caller keeps until the message is encoded.
namespace robotlink::websocket {

struct ServerInfo {
  static constexpr char kOp[] = "serverInfo";
  std::string name;
  std::vector<std::string> capabilities, supportedEncodings;
  std::map<std::string, std::string> metadata;
  std::string sessionId;
  /// The range of what is played, for servers that play a log.
  std::optional<Instant> dataStart, dataEnd;
  bool operator==(const ServerInfo&) const = default;
};

enum class StatusLevel { kInfo, kWarning, kError };
struct Status {
  static constexpr char kOp[] = "status";
  StatusLevel level = StatusLevel::kInfo;
  std::string message;
  /// Names it for removal; may be empty.
  std::string id;
  bool operator==(const Status&) const = default;
};
struct RemoveStatus {
  static constexpr char kOp[] = "removeStatus";
  std::vector<std::string> ids;
  bool operator==(const RemoveStatus&) const = default;
};

/// A stream that can be subscribed to. An id may be used again only with the same topic, encoding and schema.
struct Channel {
  std::uint64_t id = 0;
  std::string topic, encoding, schemaName, schema;
  /// Empty: that of the encoding.
  std::string schemaEncoding;
  bool operator==(const Channel&) const = default;
};
struct Advertise {
  static constexpr char kOp[] = "advertise";
  std::vector<Channel> channels;
  bool operator==(const Advertise&) const = default;
};
struct Unadvertise {
  static constexpr char kOp[] = "unadvertise";
  std::vector<std::uint64_t> channelIds;
  bool operator==(const Unadvertise&) const = default;
};

struct ParameterValues {
  static constexpr char kOp[] = "parameterValues";
  std::vector<Parameter> parameters;
  /// The id of the request that it answers; empty if there is none.
  std::string id;
  bool operator==(const ParameterValues&) const = default;
};

/// The type of a service's request or response.
struct ServiceSchema {
  std::string encoding, schemaName, schemaEncoding, schema;
  bool operator==(const ServiceSchema&) const = default;
};
struct Service {
  std::uint32_t id = 0;
  std::string name, type;
  ServiceSchema request, response;
  bool operator==(const Service&) const = default;
};
struct AdvertiseServices {
  static constexpr char kOp[] = "advertiseServices";
  std::vector<Service> services;
  bool operator==(const AdvertiseServices&) const = default;
};
struct UnadvertiseServices {
  static constexpr char kOp[] = "unadvertiseServices";
  std::vector<std::uint32_t> serviceIds;
  bool operator==(const UnadvertiseServices&) const = default;
};
struct ServiceCallFailure {
  static constexpr char kOp[] = "serviceCallFailure";
  std::uint32_t serviceId = 0, callId = 0;
  std::string message;
  bool operator==(const ServiceCallFailure&) const = default;
};

/// The ids of publishers, subscribers and providers, by name. An update has the names that changed.
struct ConnectionGraphUpdate {
  static constexpr char kOp[] = "connectionGraphUpdate";
  using Ids = std::map<std::string, std::vector<std::string>>;
  Ids publishedTopics, subscribedTopics, advertisedServices;
  std::vector<std::string> removedTopics, removedServices;
  bool operator==(const ConnectionGraphUpdate&) const = default;
};

struct MessageData {
  static constexpr std::uint8_t kOpcode = 1;
  std::uint32_t subscriptionId = 0;
  Instant time;
  std::string_view payload;
  bool operator==(const MessageData&) const = default;
};
struct Time {
  static constexpr std::uint8_t kOpcode = 2;
  Instant time;
  bool operator==(const Time&) const = default;
};
struct ServiceCallResponse {
  static constexpr std::uint8_t kOpcode = 3;
  std::uint32_t serviceId = 0, callId = 0;
  std::string encoding;
  std::string_view payload;
  bool operator==(const ServiceCallResponse&) const = default;
};
struct FetchAssetResponse {
  static constexpr std::uint8_t kOpcode = 4;
  std::uint32_t requestId = 0;
  /// Empty if there is the asset.
  std::string error;
  std::string_view data;
  bool operator==(const FetchAssetResponse&) const = default;
};

struct PlaybackState {
  static constexpr std::uint8_t kOpcode = 5;
  enum class Phase : std::uint8_t { kPlaying, kPaused, kBuffering, kEnded };
  Phase phase = Phase::kPaused;
  Instant time;
  float speed = 1;
  bool didSeek = false;
  /// The id of the request that it answers; empty if there is none.
  std::string requestId;
  bool operator==(const PlaybackState&) const = default;
};

using ServerMessage =
    std::variant<ServerInfo, Status, RemoveStatus, Advertise, Unadvertise, ParameterValues, AdvertiseServices,
                 UnadvertiseServices, ServiceCallFailure, ConnectionGraphUpdate, MessageData, Time,
                 ServiceCallResponse, FetchAssetResponse, PlaybackState>;

}  // namespace robotlink::websocket
