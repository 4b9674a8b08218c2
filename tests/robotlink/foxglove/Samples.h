// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket::test {

/// A message as a value, and as the wire has it.
template <typename Message>
struct Sample {
  Message message;
  std::string wire;
};

inline Instant at(std::int64_t nanoseconds) {
  return Instant(Duration(nanoseconds));
}

/// Texts may contain zeros.
template <std::size_t N>
std::string bytes(const char (&text)[N]) {
  return {text, N - 1};
}

inline std::vector<Parameter> sampleParameters() {
  using Array = Value::Array;
  return {{"a", Value{true}},
          {"b", Value{std::int64_t{-3}}},
          {"c", Value{3.0}},
          {"d", Value{std::string("text")}},
          {"e", Value{Value::Bytes{0, 255, 1}}},
          {"f", Value{Array{Value{1.5}, Value{2.0}}}},
          {"g", Value{Array{Value{std::int64_t{1}}, Value{false}}}},
          {"h", Value{Value::Object{{"x", Value{std::int64_t{1}}}, {"y", Value{Array{}}}}}},
          {"i", std::nullopt}};
}

inline const char kSampleParameters[] =
    R"([{"name":"a","value":true},{"name":"b","value":-3},{"name":"c","type":"float64","value":3.0},)"
    R"({"name":"d","value":"text"},{"name":"e","type":"byte_array","value":"AP8B"},)"
    R"({"name":"f","type":"float64_array","value":[1.5,2.0]},{"name":"g","value":[1,false]},)"
    R"({"name":"h","value":{"x":1,"y":[]}},{"name":"i"}])";

/// Every message of a server.
inline std::vector<Sample<ServerMessage>> serverSamples() {
  const std::string parameters = kSampleParameters;
  return {
      {ServerInfo{"red1", {"time"}, {"json"}, {{"k", "v"}}, "s1", at(1'000'000'002), at(2'500'000'000)},
       R"({"capabilities":["time"],"dataEndTime":{"nsec":500000000,"sec":2},"dataStartTime":{"nsec":2,"sec":1},)"
       R"("metadata":{"k":"v"},"name":"red1","op":"serverInfo","sessionId":"s1","supportedEncodings":["json"]})"},
      {ServerInfo{"red1", {}, {}, {}, "", {}, {}}, R"({"capabilities":[],"name":"red1","op":"serverInfo"})"},
      {Status{StatusLevel::kWarning, "low", "battery"},
       R"({"id":"battery","level":1,"message":"low","op":"status"})"},
      {RemoveStatus{{"battery"}}, R"({"op":"removeStatus","statusIds":["battery"]})"},
      {Advertise{{{7, "red1/log", "json", "Log", "{}", "jsonschema"},
                  {8, "p", "protobuf", "P", bytes("\0\xff"), ""}}},
       R"({"channels":[{"encoding":"json","id":7,"schema":"{}","schemaEncoding":"jsonschema","schemaName":"Log",)"
       R"("topic":"red1/log"},{"encoding":"protobuf","id":8,"schema":"AP8=","schemaName":"P","topic":"p"}],"op":"advertise"})"},
      {Unadvertise{{7, 1ULL << 40U}}, R"({"channelIds":[7,1099511627776],"op":"unadvertise"})"},
      {ParameterValues{sampleParameters(), "r1"},
       R"({"id":"r1","op":"parameterValues","parameters":)" + parameters + "}"},
      {AdvertiseServices{
           {{3, "stop", "Stop", {"json", "A", "jsonschema", "{}"}, {"protobuf", "B", "protobuf", "\x01"}}}},
       R"({"op":"advertiseServices","services":[{"id":3,"name":"stop",)"
       R"("request":{"encoding":"json","schema":"{}","schemaEncoding":"jsonschema","schemaName":"A"},)"
       R"("response":{"encoding":"protobuf","schema":"AQ==","schemaEncoding":"protobuf","schemaName":"B"},"type":"Stop"}]})"},
      {UnadvertiseServices{{3}}, R"({"op":"unadvertiseServices","serviceIds":[3]})"},
      {ServiceCallFailure{3, 9, "no"},
       R"({"callId":9,"message":"no","op":"serviceCallFailure","serviceId":3})"},
      {ConnectionGraphUpdate{{{"t", {"p", "q"}}}, {{"u", {}}}, {{"s", {"p"}}}, {"gone"}, {"away"}},
       R"({"advertisedServices":[{"name":"s","providerIds":["p"]}],"op":"connectionGraphUpdate",)"
       R"("publishedTopics":[{"name":"t","publisherIds":["p","q"]}],"removedServices":["away"],"removedTopics":["gone"],)"
       R"("subscribedTopics":[{"name":"u","subscriberIds":[]}]})"},
      {MessageData{0x01020304, at(0x1122334455667788), "ab"},
       bytes("\x01\x04\x03\x02\x01\x88\x77\x66\x55\x44\x33\x22\x11"
             "ab")},
      {Time{at(5)}, bytes("\x02\x05\0\0\0\0\0\0\0")},
      {ServiceCallResponse{3, 9, "json", "{}"}, bytes("\x03\x03\0\0\0\x09\0\0\0\x04\0\0\0json{}")},
      {FetchAssetResponse{6, "", "data"}, bytes("\x04\x06\0\0\0\0\0\0\0\0data")},
      {FetchAssetResponse{6, "no", ""}, bytes("\x04\x06\0\0\0\x01\x02\0\0\0no")},
      {PlaybackState{PlaybackState::Phase::kEnded, at(1), 2.0F, true, "r"},
       bytes("\x05\x03\x01\0\0\0\0\0\0\0\0\0\0\x40\x01\x01\0\0\0r")},
  };
}

/// Every message of a client.
inline std::vector<Sample<ClientMessage>> clientSamples() {
  const std::string parameters = kSampleParameters;
  return {
      {Subscribe{{{1, 7}, {2, 8}}},
       R"({"op":"subscribe","subscriptions":[{"channelId":7,"id":1},{"channelId":8,"id":2}]})"},
      {Unsubscribe{{1}}, R"({"op":"unsubscribe","subscriptionIds":[1]})"},
      {ClientAdvertise{{{4, "drive", "json", "Drive", "{}", "jsonschema"}}},
       R"({"channels":[{"encoding":"json","id":4,"schema":"{}","schemaEncoding":"jsonschema","schemaName":"Drive",)"
       R"("topic":"drive"}],"op":"advertise"})"},
      {ClientUnadvertise{{4}}, R"({"channelIds":[4],"op":"unadvertise"})"},
      {GetParameters{{"a"}, "r1"}, R"({"id":"r1","op":"getParameters","parameterNames":["a"]})"},
      {SetParameters{sampleParameters(), "r2"},
       R"({"id":"r2","op":"setParameters","parameters":)" + parameters + "}"},
      {SubscribeParameterUpdates{{}}, R"({"op":"subscribeParameterUpdates","parameterNames":[]})"},
      {UnsubscribeParameterUpdates{{"a"}}, R"({"op":"unsubscribeParameterUpdates","parameterNames":["a"]})"},
      {SubscribeConnectionGraph{}, R"({"op":"subscribeConnectionGraph"})"},
      {UnsubscribeConnectionGraph{}, R"({"op":"unsubscribeConnectionGraph"})"},
      {FetchAsset{"package://a.stl", 6}, R"({"op":"fetchAsset","requestId":6,"uri":"package://a.stl"})"},
      {ClientMessageData{4, "{}"}, bytes("\x01\x04\0\0\0{}")},
      {ServiceCallRequest{3, 9, "json", "{}"}, bytes("\x02\x03\0\0\0\x09\0\0\0\x04\0\0\0json{}")},
      {PlaybackControl{PlaybackControl::Command::kPause, 0.5F, at(3), "r"},
       bytes("\x03\x01\0\0\0\x3f\x01\x03\0\0\0\0\0\0\0\x01\0\0\0r")},
      {PlaybackControl{PlaybackControl::Command::kPlay, 1.0F, {}, ""},
       bytes("\x03\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0")},
  };
}

}  // namespace robotlink::websocket::test
