// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/ServiceArgument.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::failure;
using robotlink::websocket::Service;
using robotlink::websocket::ServiceSchema;

constexpr char kJsonCoding[] = "json";

/// "recordings.Read" for "recordings/read".
std::string typeNameOf(const std::string& service) {
  std::string name = service;
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos || slash + 1 == name.size()) return name;
  name[slash] = '.';
  if (name[slash + 1] >= 'a' && name[slash + 1] <= 'z')
    name[slash + 1] = static_cast<char>(name[slash + 1] - 'a' + 'A');
  return name;
}

}  // namespace

Service jsonService(const std::string& name, const std::vector<ArgumentMember>& members) {
  const std::string request = typeNameOf(name) + "Request", response = typeNameOf(name) + "Response";
  json properties = json::object();
  for (const ArgumentMember& member : members) {
    json& schema = properties[member.name];
    schema["type"] = member.isNumber ? "integer" : "string";
    if (member.isNumber) schema["minimum"] = 0;
  }
  const json argument{{"type", "object"},
                      {"title", request},
                      {"properties", std::move(properties)},
                      {"additionalProperties", false}};
  const json answer{{"type", "object"}, {"title", response}};
  return {0,
          name,
          request,
          {kJsonCoding, request, "jsonschema", argument.dump()},
          {kJsonCoding, response, "jsonschema", answer.dump()}};
}

robotlink::Result<json> argumentOfCall(const std::string& name, const std::vector<ArgumentMember>& members,
                                       const robotlink::websocket::ServiceCallRequest& call) {
  const auto wrong = [](std::string text) { return failure("service.argument", std::move(text)); };
  if (call.encoding != kJsonCoding)
    return wrong(name + " takes JSON, not '" + std::string(call.encoding) + "'");
  auto argument = json::parse(call.payload.empty() ? "{}" : call.payload, nullptr, false);
  if (!argument.is_object()) return wrong("the argument of " + name + " is not a JSON object");
  for (const auto& [key, value] : argument.items()) {
    const auto member = std::ranges::find(members, key, &ArgumentMember::name);
    if (member == members.end()) return wrong(name + " takes no " + jsonMessage(json(key)));
    if (member->isNumber ? value.is_number_unsigned() : value.is_string()) continue;
    return wrong("'" + key + "' of " + name + " is not a " + (member->isNumber ? "whole number" : "text"));
  }
  return argument;
}

std::string textMember(const json& argument, const char* member) {
  const auto found = argument.find(member);
  return found != argument.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::uint64_t numberMember(const json& argument, const char* member, std::uint64_t otherwise) {
  const auto found = argument.find(member);
  return found != argument.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : otherwise;
}

}  // namespace app
