// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/RequestServices.h"

#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using nlohmann::json;
using robotcontrol::Request;
namespace util = google::protobuf::util;

constexpr char kJson[] = "json", kProtobuf[] = "protobuf";

/// Whether a request is for one robot or for all: where programs run is chosen for one robot, or for all at
/// once; ports are those of a robot or of any model.
bool isOfBoth(const RequestKind& kind) {
  return kind.what == Request::kHostProgram || kind.what == Request::kSetActuator ||
         kind.what == Request::kReadPorts;
}

bool isOfRobot(const RequestKind& kind) {
  return kind.isOfProgram() || kind.doer == RequestDoer::kPlatform || isOfBoth(kind);
}

bool isOfWorld(const RequestKind& kind) {
  return !isOfRobot(kind) || isOfBoth(kind);
}

/// The field of a Request that has the message of a kind.
const FieldDescriptor& fieldOf(const RequestKind& kind) {
  return *Request::descriptor()->FindFieldByNumber(static_cast<int>(kind.what));
}

std::string prefixOf(const std::string& robot) {
  return robot.empty() ? std::string() : robot + "/";
}

json schemaOfField(const FieldDescriptor& field, int depth);

json schemaOfMessage(const Descriptor& type, int depth) {
  // How JSON has them.
  if (type.full_name() == "google.protobuf.Timestamp") return {{"type", "string"}, {"format", "date-time"}};
  if (type.full_name() == "google.protobuf.Duration") return {{"type", "string"}, {"format", "duration"}};
  json properties = json::object();
  // Messages that contain themselves end somewhere.
  for (int i = 0; depth > 0 && i < type.field_count(); ++i) {
    properties[type.field(i)->name()] = schemaOfField(*type.field(i), depth - 1);
  }
  return {{"type", "object"}, {"title", type.full_name()}, {"properties", std::move(properties)}};
}

json schemaOfValue(const FieldDescriptor& field, int depth) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return schemaOfMessage(*field.message_type(), depth);
    case FieldDescriptor::CPPTYPE_BOOL:
      return {{"type", "boolean"}};
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_FLOAT:
      return {{"type", "number"}};
    case FieldDescriptor::CPPTYPE_ENUM: {
      json names = json::array();
      for (int i = 0; i < field.enum_type()->value_count(); ++i)
        names.push_back(field.enum_type()->value(i)->name());
      return {{"type", "string"}, {"enum", std::move(names)}};
    }
    case FieldDescriptor::CPPTYPE_STRING: {
      json result = {{"type", "string"}};
      if (field.type() == FieldDescriptor::TYPE_BYTES) result["contentEncoding"] = "base64";
      return result;
    }
    default:
      return {{"type", "integer"}};
  }
}

json schemaOfField(const FieldDescriptor& field, int depth) {
  json value = schemaOfValue(field, depth);
  return field.is_repeated() ? json{{"type", "array"}, {"items", std::move(value)}} : value;
}

ServiceSchema schemaFor(const Descriptor& type) {
  return {kJson, type.full_name(), "jsonschema", jsonSchemaOf(type)};
}

Service serviceFor(const std::string& name, const Descriptor& argument) {
  static const ServiceSchema kResult = schemaFor(*robotcontrol::RequestResult::descriptor());
  return {0, name, argument.full_name(), schemaFor(argument), kResult};
}

/// The services of all robots, or of the world, by their kinds alone.
std::vector<Service> servicesOf(bool robots) {
  std::vector<Service> services;
  for (const RequestKind& kind : requestKinds()) {
    if (robots ? isOfRobot(kind) : isOfWorld(kind))
      services.push_back(serviceFor(fieldOf(kind).name(), *fieldOf(kind).message_type()));
  }
  return services;
}

/// Older clients serialize a speed of 0, which is as fast as possible, as nothing; what is left then asks for
/// nothing else.
void addOldSpeed(Request& request) {
  if (!request.has_control_simulation()) return;
  robotcontrol::ControlSimulation& control = *request.mutable_control_simulation();
  if (control.action() == robotcontrol::ControlSimulation::UNCHANGED && !control.has_speed())
    control.set_speed(0);
}

/// Servers of older versions, to which a session passes it on, take an empty one for a release.
void nameStop(Request& request) {
  if (request.has_stop()) request.mutable_stop()->set_engaged(engagesStop(request));
}

}  // namespace

std::string jsonSchemaOf(const Descriptor& type) {
  constexpr int kDepth = 8;
  return schemaOfMessage(type, kDepth).dump();
}

std::vector<Service> requestServices(const std::string& robot) {
  // Their schemas are large, and the same for all robots.
  static const std::vector<Service> kOfRobots = servicesOf(true), kOfWorld = servicesOf(false);
  std::vector<Service> services = robot.empty() ? kOfWorld : kOfRobots;
  for (Service& service : services) service.name.insert(0, prefixOf(robot));
  return services;
}

Service steerService(const std::string& robot) {
  static const Service kService = serviceFor("steer", *robotcontrol::Steer::descriptor());
  Service service = kService;
  service.name.insert(0, prefixOf(robot));
  return service;
}

Result<Request> requestOf(const std::string& robot, const std::string& service,
                          const ServiceCallRequest& call) {
  Request request;
  request.set_robot(robot);
  const std::string name = service.substr(prefixOf(robot).size());
  const FieldDescriptor* field = Request::descriptor()->FindFieldByName(name);
  if (field == nullptr || field->containing_oneof() == nullptr) {
    return failure("foxglove.service", "there is no service '" + service + "'");
  }
  google::protobuf::Message& message = *Request::GetReflection()->MutableMessage(&request, field);
  const std::string payload(call.payload);
  if (call.encoding == kProtobuf) {
    if (!message.ParseFromString(payload)) {
      return failure("foxglove.service", "the argument is no " + field->message_type()->full_name());
    }
    addOldSpeed(request);
  } else if (call.encoding == kJson) {
    const auto status = payload.empty() ? util::Status() : util::JsonStringToMessage(payload, &message);
    if (!status.ok()) {
      return failure("foxglove.service",
                     "the argument is no " + field->message_type()->full_name() + ": " + status.ToString());
    }
  } else {
    return failure("foxglove.service", "the encoding of arguments must be 'json' or 'protobuf', not '" +
                                           std::string(call.encoding) + "'");
  }
  nameStop(request);
  if (const std::string wrong = wrongWith(request); !wrong.empty()) return failure("foxglove.service", wrong);
  return request;
}

std::string encodeResult(const robotcontrol::RequestResult& result, const std::string& encoding) {
  if (encoding == kProtobuf) return result.SerializeAsString();
  std::string text;
  util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  static_cast<void>(util::MessageToJsonString(result, &text, options));
  return text;
}

}  // namespace robotlink::websocket
