// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/RequestServices.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"

namespace robotlink::websocket {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> namesOf(const std::vector<Service>& services) {
  std::vector<std::string> names;
  for (const Service& service : services) names.push_back(service.name);
  return names;
}

ServiceCallRequest callWith(const std::string& payload, const std::string& encoding = "json") {
  return {0, 0, encoding, payload};
}

TEST(RequestServices, eachKindOfRequestIsAServiceOfARobotOrOfTheWorld) {
  const auto robot = namesOf(requestServices("red1")), world = namesOf(requestServices(""));
  // Programs, sensors and actuators may be those of one robot, or of all and of what is no robot.
  EXPECT_EQ(robot.size() + world.size(), requestKinds().size() + 3);
  EXPECT_THAT(robot, Contains("red1/set_key"));
  EXPECT_THAT(robot, Contains("red1/stop"));
  EXPECT_THAT(world, Contains("control_simulation"));
  EXPECT_THAT(robot, Not(Contains("red1/control_simulation")));
}

TEST(RequestServices, theProgramOfOneRobotOrThoseOfAllAreStartedAgain) {
  EXPECT_THAT(namesOf(requestServices("red1")), Contains("red1/host_program"));
  EXPECT_THAT(namesOf(requestServices("")), Contains("host_program"));
  const auto one = requestOf("red1", "red1/host_program", callWith(R"({"start_again": true})"));
  ASSERT_TRUE(one) << one.error().text;
  EXPECT_EQ(one->robot(), "red1");
  EXPECT_TRUE(one->host_program().start_again());
  const auto all = requestOf("", "host_program", callWith(R"({"start_again": true})"));
  ASSERT_TRUE(all) << all.error().text;
  EXPECT_EQ(all->robot(), "");
}

TEST(RequestServices, anArgumentIsJsonOrASerializedMessage) {
  const auto request = requestOf("red1", "red1/set_key",
                                 callWith(R"({"name": "package/camera/image", "mode": {"kind": "ALWAYS"}})"));
  ASSERT_TRUE(request) << request.error().text;
  EXPECT_EQ(request->robot(), "red1");
  EXPECT_EQ(request->set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
  const std::string bytes = request->set_key().SerializeAsString();
  const auto same = requestOf("red1", "red1/set_key", callWith(bytes, "protobuf"));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->SerializeAsString(), request->SerializeAsString());
}

TEST(RequestServices, aRequestWithoutAnArgumentNeedsNone) {
  const auto request = requestOf("red1", "red1/send_tables", callWith(""));
  ASSERT_TRUE(request) << request.error().text;
  EXPECT_TRUE(request->has_send_tables());
}

TEST(RequestServices, anEmptyStopStopsAndOnlyAnExplicitOneReleases) {
  const auto isEngaged = [](const std::string& payload, const std::string& encoding) {
    const auto request = requestOf("red1", "red1/stop", callWith(payload, encoding));
    EXPECT_TRUE(request && request->stop().has_engaged());
    return request && request->stop().engaged();
  };
  EXPECT_TRUE(isEngaged("{}", "json"));
  EXPECT_TRUE(isEngaged("", "json"));
  EXPECT_TRUE(isEngaged("", "protobuf"));
  EXPECT_TRUE(isEngaged(R"({"engaged": true})", "json"));
  EXPECT_FALSE(isEngaged(R"({"engaged": false})", "json"));
  robotcontrol::Stop release;
  release.set_engaged(false);
  EXPECT_FALSE(isEngaged(release.SerializeAsString(), "protobuf"));
}

TEST(RequestServices, aSpeedThatIsLeftOutStaysUnlessAnOlderClientMeansZero) {
  const auto control = [](const std::string& payload, const std::string& encoding) {
    const auto request = requestOf("", "control_simulation", callWith(payload, encoding));
    EXPECT_TRUE(request);
    return request ? request->control_simulation() : robotcontrol::ControlSimulation();
  };
  EXPECT_FALSE(control(R"({"action": "RESET"})", "json").has_speed());
  EXPECT_FALSE(control("{}", "json").has_speed());
  EXPECT_TRUE(control(R"({"speed": 0})", "json").has_speed());
  robotcontrol::ControlSimulation reset;
  reset.set_action(robotcontrol::ControlSimulation::RESET);
  EXPECT_FALSE(control(reset.SerializeAsString(), "protobuf").has_speed());
  const auto fast = control("", "protobuf");
  EXPECT_TRUE(fast.has_speed());
  EXPECT_EQ(fast.speed(), 0);
}

TEST(RequestServices, aWrongArgumentIsRefusedWithTheReason) {
  const auto reason = [](const std::string& payload, const std::string& encoding) {
    const auto request = requestOf("red1", "red1/set_key", callWith(payload, encoding));
    return request ? std::string() : request.error().text;
  };
  EXPECT_THAT(reason("{", "json"), HasSubstr("robotcontrol.SetKey"));
  EXPECT_THAT(reason(R"({"nam": "x"})", "json"), HasSubstr("nam"));
  EXPECT_THAT(reason("\xFF\xFF", "protobuf"), HasSubstr("robotcontrol.SetKey"));
  EXPECT_THAT(reason("{}", "cdr"), HasSubstr("cdr"));
  EXPECT_THAT(reason(R"({"name": "no-such-key"})", "json"), HasSubstr("no-such-key"));
  EXPECT_FALSE(requestOf("red1", "red1/id", callWith("1")));
}

TEST(RequestServices, aResultHasTheNamesOfItsProtoFile) {
  robotcontrol::RequestResult result;
  result.set_accepted(false);
  result.set_reason("no");
  const json value = json::parse(encodeResult(result, "json"));
  EXPECT_EQ(value["accepted"], false);
  EXPECT_EQ(value["reason"], "no");
  robotcontrol::RequestResult parsed;
  ASSERT_TRUE(parsed.ParseFromString(encodeResult(result, "protobuf")));
  EXPECT_EQ(parsed.reason(), "no");
}

TEST(RequestServices, aSchemaNamesFieldsTypesAndTheWordsOfAnEnumeration) {
  const json schema = json::parse(jsonSchemaOf(*robotcontrol::SetKey::descriptor()));
  EXPECT_EQ(schema["properties"]["name"]["type"], "string");
  const json& mode = schema["properties"]["mode"];
  EXPECT_EQ(mode["type"], "object");
  EXPECT_EQ(mode["properties"]["n"]["type"], "integer");
  EXPECT_THAT(mode["properties"]["kind"]["enum"].get<std::vector<std::string>>(), Contains("ALWAYS"));
}

}  // namespace
}  // namespace robotlink::websocket
