// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"
#include "robotlink/foxglove/server/ServerOptions.h"

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
}  // namespace google::protobuf
namespace robotcontrol {
class Request;
class RequestResult;
}  // namespace robotcontrol

namespace robotlink::websocket {

// Requests (robotlink/packages/robotcontrol/Requests.proto) as services: one for each kind, its argument is
// the message of that kind, its answer the RequestResult. "red1/set_key" with {"name": "ball-percept/disc",
// "mode": {"kind": "ALWAYS"}}; "control_simulation" is of no robot; "red1/host_program" is of one, and
// "host_program" of all. Arguments are JSON, with the names of the
// .proto file, or the serialized message, as the call says; the answer has the same encoding.

/// All kinds of requests to a robot, or with an empty name to the world.
std::vector<Service> requestServices(const std::string& robot);
/// The service by which a client takes over a robot, "red1/steer", with a robotcontrol.Steer as argument.
Service steerService(const std::string& robot);
/// The request of a call of such a service. The error says what is wrong with the call.
Result<robotcontrol::Request> requestOf(const std::string& robot, const std::string& service,
                                        const ServiceCallRequest& call);
/// The result in an encoding, "json" or "protobuf".
std::string encodeResult(const robotcontrol::RequestResult& result, const std::string& encoding);

/// The JSON Schema of a message, as JSON is read and written here.
std::string jsonSchemaOf(const google::protobuf::Descriptor& type);

}  // namespace robotlink::websocket
