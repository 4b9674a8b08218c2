// SPDX-License-Identifier: GPL-3.0-or-later
// With messages that are no parameters, but have fields of all kinds.
#include "robotlink/foxglove/session/ModuleParameters.h"

#include <gmock/gmock.h>

#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace robotlink::websocket {
namespace {

using robotcontrol::DriveState;
using robotcontrol::GroundMap;
using robotcontrol::Request;
using testing::HasSubstr;
using testing::IsEmpty;

template <typename Message>
robotcontrol::ParameterValues valuesOf(const Message& message) {
  robotcontrol::ParameterValues values;
  values.set_task("walking");
  values.set_solution("gait");
  values.mutable_value()->set_type(message.GetTypeName());
  values.mutable_value()->set_data(message.SerializeAsString());
  return values;
}

std::map<std::string, std::optional<Value>> byName(const std::vector<Parameter>& parameters) {
  std::map<std::string, std::optional<Value>> result;
  for (const Parameter& parameter : parameters) result[parameter.name] = parameter.value;
  return result;
}

const std::string kGait = "red1/parameters/walking/gait/";

class ModuleParametersTest : public testing::Test {
 protected:
  DriveState settingOf(const std::string& field, Value value) {
    const auto requests = modules_.requestsFor({{kGait + field, std::move(value)}});
    problem_ = requests ? "" : requests.error().text;
    DriveState state;
    if (requests) state.ParseFromString(requests->at(0).set_parameters().value().data());
    return state;
  }

  ModuleParameters modules_;
  std::string problem_;
};

TEST_F(ModuleParametersTest, fieldsAreParametersOfTheirTypes) {
  DriveState state;
  state.mutable_odometry()->set_x(1.5);
  state.add_front_bumpers(true);
  state.set_fault_flags(7);
  const auto values = byName(modules_.take("red1", valuesOf(state)));
  EXPECT_EQ(values.at(kGait + "odometry/x"), Value{1.5});
  EXPECT_EQ(values.at(kGait + "front_bumpers"), (Value{Value::Array{Value{true}}}));
  EXPECT_EQ(values.at(kGait + "fault_flags"), Value{std::int64_t{7}});
  EXPECT_EQ(values.at(kGait + "motors_on"), Value{false});
  EXPECT_EQ(values.at(kGait + "charging"), Value{std::string("UNKNOWN")});
  EXPECT_TRUE(modules_.has(kGait + "odometry/x"));
  EXPECT_FALSE(modules_.has(kGait + "odometry"));
  // Only what changed is told.
  state.set_motors_on(true);
  const auto changes = modules_.take("red1", valuesOf(state));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].name, kGait + "motors_on");
}

TEST_F(ModuleParametersTest, elementsOfListsOfMessagesHaveNumbersAndMayGo) {
  GroundMap map;
  map.add_lines()->set_x1(4);
  map.add_lines();
  EXPECT_EQ(byName(modules_.take("red1", valuesOf(map))).at(kGait + "lines/0/x1"), Value{4.0});
  const auto set = modules_.requestsFor({{kGait + "lines/1/y2", Value{std::int64_t{3}}}});
  ASSERT_TRUE(set);
  GroundMap changed;
  ASSERT_TRUE(changed.ParseFromString(set->at(0).set_parameters().value().data()));
  EXPECT_EQ(changed.lines(1).y2(), 3);
  map.mutable_lines()->RemoveLast();
  const auto gone = byName(modules_.take("red1", valuesOf(map)));
  EXPECT_EQ(gone.at(kGait + "lines/1/y2"), std::nullopt);
  EXPECT_FALSE(modules_.has(kGait + "lines/1/y2"));
}

TEST_F(ModuleParametersTest, aValueMustFitItsField) {
  modules_.take("red1", valuesOf(DriveState()));
  EXPECT_EQ(settingOf("battery", Value{std::int64_t{12}}).battery(), 12);
  EXPECT_EQ(settingOf("digital_in", Value{3.0}).digital_in(), 3U);
  EXPECT_EQ(settingOf("charging", Value{std::string("CHARGING")}).charging(), DriveState::CHARGING);
  EXPECT_EQ(settingOf("front_bumpers", Value{Value::Array{Value{true}, Value{false}}}).front_bumpers_size(),
            2);
  const auto problemWith = [&](const std::string& field, Value value) {
    settingOf(field, std::move(value));
    return problem_;
  };
  EXPECT_THAT(problemWith("battery", Value{std::string("x")}), HasSubstr("is a number"));
  EXPECT_THAT(problemWith("digital_in", Value{2.5}), HasSubstr("whole number"));
  EXPECT_THAT(problemWith("digital_in", Value{std::int64_t{-1}}), HasSubstr("whole number"));
  EXPECT_THAT(problemWith("digital_in", Value{1e300}), HasSubstr("whole number"));
  EXPECT_THAT(problemWith("motors_on", Value{std::int64_t{1}}), HasSubstr("true or false"));
  EXPECT_THAT(problemWith("charging", Value{std::string("x")}), HasSubstr("UNKNOWN, NOT_CHARGING"));
  EXPECT_THAT(problemWith("front_bumpers", Value{true}), HasSubstr("is a list"));
  EXPECT_THAT(problemWith("front_bumpers", Value{Value::Array{Value{2.0}}}), HasSubstr("each element"));
  EXPECT_THAT(problemWith("none", Value{2.0}), HasSubstr("no such parameter"));
  EXPECT_THAT(modules_.requestsFor({{kGait + "battery", std::nullopt}}).error().text, HasSubstr("removed"));
}

TEST_F(ModuleParametersTest, severalOfOneSolutionAreOneRequestAndTheNextBuildsOnIt) {
  modules_.take("red1", valuesOf(DriveState()));
  const auto requests =
      modules_.requestsFor({{kGait + "battery", Value{9.0}}, {kGait + "motors_on", Value{true}}});
  ASSERT_TRUE(requests);
  ASSERT_EQ(requests->size(), 1U);
  EXPECT_EQ(requests->at(0).robot(), "red1");
  EXPECT_EQ(requests->at(0).set_parameters().task(), "walking");
  EXPECT_EQ(requests->at(0).set_parameters().solution(), "gait");
  modules_.expect(requests->at(0));
  const DriveState next = settingOf("sonar_on", Value{true});
  EXPECT_TRUE(next.sonar_on() && next.motors_on());
  EXPECT_EQ(next.battery(), 9);
}

TEST_F(ModuleParametersTest, eachSolutionOfTheTableIsAskedForOnce) {
  robotcontrol::SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_name("walking");
  for (const char* name : {"gait", "glide", "none"}) {
    task.add_solutions()->set_name(name);
    task.mutable_solutions()->rbegin()->set_has_parameters(name != std::string("none"));
  }
  modules_.keep("red1", table);
  std::vector<std::string> asked;
  while (const auto request = modules_.nextToGet("red1"))
    asked.push_back(request->get_parameters().solution());
  EXPECT_THAT(asked, testing::ElementsAre("gait", "glide"));
  modules_.keep("red1", table);
  EXPECT_FALSE(modules_.nextToGet("red1"));
  modules_.take("red1", valuesOf(DriveState()));
  EXPECT_THAT(modules_.keep("red2", {}), IsEmpty());
  EXPECT_GT(modules_.remove("red1").size(), 10U);
  EXPECT_FALSE(modules_.has(kGait + "battery"));
}

TEST_F(ModuleParametersTest, typesThatAreNotKnownAreNotOffered) {
  robotcontrol::ParameterValues values = valuesOf(DriveState());
  modules_.take("red1", values);
  values.mutable_value()->set_type("robotcontrol.Nothing");
  EXPECT_GT(modules_.take("red1", values).size(), 10U);  // all gone
  EXPECT_THAT(modules_.take("red1", values), IsEmpty());
}

}  // namespace
}  // namespace robotlink::websocket
