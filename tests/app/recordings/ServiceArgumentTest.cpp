// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/ServiceArgument.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace app {
namespace {

using robotlink::websocket::ServiceCallRequest;
using testing::HasSubstr;

const std::vector<ArgumentMember> kMembers{{"name"}, {"bytes", true}};

/// What is wrong with an argument; empty: nothing.
std::string wrongWith(const std::string& payload, const std::vector<ArgumentMember>& members = kMembers) {
  const auto argument = argumentOfCall("recordings/read", members, ServiceCallRequest{1, 1, "json", payload});
  return argument ? std::string() : argument.error().text;
}

TEST(ServiceArgument, membersThatTheServiceDoesNotHaveAreRefused) {
  EXPECT_EQ(wrongWith(""), "");
  EXPECT_EQ(wrongWith("{}"), "");
  EXPECT_EQ(wrongWith(R"({"name": "a.mcap", "bytes": 7})"), "");
  EXPECT_THAT(wrongWith(R"({"name": "a.mcap"})", {}), HasSubstr(R"(recordings/read takes no "name")"));
  EXPECT_THAT(wrongWith(R"({"Name": "a.mcap"})"), HasSubstr("takes no"));
}

TEST(ServiceArgument, valuesThatDoNotFitAreRefused) {
  for (const char* payload : {R"({"bytes": "7"})", R"({"bytes": -7})", R"({"bytes": 0.5})"})
    EXPECT_THAT(wrongWith(payload), HasSubstr("'bytes' of recordings/read is not a whole number")) << payload;
  EXPECT_THAT(wrongWith(R"({"name": 7})"), HasSubstr("'name' of recordings/read is not a text"));
  EXPECT_THAT(wrongWith("[]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(wrongWith("{"), HasSubstr("not a JSON object"));
}

TEST(ServiceArgument, aServiceSaysWhichArgumentItTakes) {
  const auto service = jsonService("recordings/read", kMembers);
  EXPECT_EQ(service.name, "recordings/read");
  EXPECT_EQ(service.type, "recordings.ReadRequest");
  EXPECT_EQ(service.request.schemaName, "recordings.ReadRequest");
  EXPECT_EQ(service.response.schemaName, "recordings.ReadResponse");
  const auto schema = nlohmann::json::parse(service.request.schema);
  EXPECT_EQ(schema["properties"]["name"]["type"], "string");
  EXPECT_EQ(schema["properties"]["bytes"]["type"], "integer");
}

}  // namespace
}  // namespace app
