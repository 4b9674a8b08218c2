// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/FieldPath.h"

#include <gmock/gmock.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"

namespace robotlink {
namespace {

using testing::HasSubstr;

foxglove::JointStates jointStates() {
  foxglove::JointStates states;
  states.mutable_timestamp()->set_seconds(2);
  states.mutable_timestamp()->set_nanos(500'000'000);
  for (const char* name : {"neck", "head.pan", "head]\""}) {
    foxglove::JointState& joint = *states.add_joints();
    joint.set_name(name);
    joint.set_position(states.joints_size());
  }
  return states;
}

std::optional<double> number(const std::string& path, const google::protobuf::Message& message) {
  const auto parsed = FieldPath::parse(path);
  EXPECT_TRUE(parsed) << parsed.error().describe();
  EXPECT_TRUE(parsed->fits(*message.GetDescriptor())) << path;
  const auto value = parsed->valueIn(message);
  return value ? value->number : std::nullopt;
}

Error refusal(const std::string& path, const google::protobuf::Descriptor& type) {
  const auto parsed = FieldPath::parse(path);
  if (!parsed) return parsed.error();
  const auto fits = parsed->fits(type);
  EXPECT_FALSE(fits) << path;
  return fits ? Error{} : fits.error();
}

TEST(FieldPath, leadsToNumbersInMessagesAndLists) {
  EXPECT_EQ(number("joints[1].position", jointStates()), 2);
  EXPECT_EQ(number("joints[-1].position", jointStates()), 3);
  EXPECT_EQ(number("joints[name=\"head.pan\"].position", jointStates()), 2);
  EXPECT_EQ(number("joints[head.pan].position", jointStates()), 2);
  EXPECT_EQ(number("joints[position=\"3\"].position", jointStates()), 3);
  EXPECT_EQ(number("joints", jointStates()), 3);
  EXPECT_EQ(number("timestamp", jointStates()), 2.5);
  robotcontrol::BallModel ball;
  ball.set_known(true);
  ball.mutable_position_in_robot()->set_x(-1.5);
  EXPECT_EQ(number("position_in_robot.x", ball), -1.5);
  EXPECT_EQ(number("known", ball), 1);
  foxglove::RawImage image;
  image.set_data("12345");
  EXPECT_EQ(number("data", image), 5);
}

TEST(FieldPath, anElementThatIsNotThereIsNamed) {
  const auto missing = [](const char* path) { return FieldPath::parse(path)->missingElement(jointStates()); };
  EXPECT_EQ(missing("joints[headPan].position"), "no element is named headPan");
  EXPECT_EQ(missing("joints[position=\"7\"].position"), "no element has the position 7");
  EXPECT_EQ(missing("joints[3].position"), "joints has no element 3");
  EXPECT_EQ(missing("joints[head.pan].position"), "");
  EXPECT_EQ(missing("timestamp"), "");
}

TEST(FieldPath, bracketsInAQuotedTextBelongToIt) {
  EXPECT_EQ(number("joints[name=\"head]\"\"].position", jointStates()), 3);
}

TEST(FieldPath, enumerationsAreNumbersAndTexts) {
  foxglove::Log log;
  log.set_level(foxglove::Log::WARNING);
  const auto value = FieldPath::parse("level")->valueIn(log);
  ASSERT_TRUE(value);
  EXPECT_EQ(value->number, 3);
  EXPECT_EQ(value->text, "WARNING");
  EXPECT_EQ(FieldPath::parse("message")->valueIn(log)->text, "");
}

TEST(FieldPath, thereIsNoValueWhereThereIsNoElementOrItIsNotSet) {
  EXPECT_EQ(number("joints[3].position", jointStates()), std::nullopt);
  EXPECT_EQ(number("joints[-4].position", jointStates()), std::nullopt);
  EXPECT_EQ(number("joints[name=\"tail\"].position", jointStates()), std::nullopt);
  EXPECT_EQ(number("joints[0].velocity", jointStates()), std::nullopt);
  EXPECT_EQ(number("position_in_robot.x", robotcontrol::BallModel()), std::nullopt);
}

TEST(FieldPath, aTypeWithoutTheFieldHasNoValueButDoesNoHarm) {
  EXPECT_FALSE(FieldPath::parse("level.x")->valueIn(foxglove::Log()));
  EXPECT_FALSE(FieldPath::parse("joints.position")->valueIn(jointStates()));
  EXPECT_FALSE(FieldPath::parse("level[0]")->valueIn(foxglove::Log()));
  EXPECT_FALSE(FieldPath::parse("joints[0]")->valueIn(jointStates()));
}

TEST(FieldPath, theFrameBehindANameMayBeLeftOutWhereItIsTheOnlyOne) {
  robotcontrol::BallModel ball;
  ball.mutable_position_in_robot()->set_x(-1.5);
  EXPECT_EQ(number("position.x", ball), -1.5);
  EXPECT_TRUE(FieldPath::parse("velocity.y")->fits(*robotcontrol::BallModel::descriptor()));
  EXPECT_THAT(refusal("posit.x", *robotcontrol::BallModel::descriptor()).text,
              HasSubstr("has no field posit"));
}

TEST(FieldPath, whatDoesNotFitIsRefusedWithItsPlaceAndTheNearestName) {
  const auto& type = *foxglove::JointStates::descriptor();
  EXPECT_THAT(refusal("joint[0].position", type).text, HasSubstr("did you mean 'joints'"));
  const Error inner = refusal("joints[0].postion", type);
  EXPECT_THAT(inner.text, HasSubstr("did you mean 'position'"));
  EXPECT_EQ(inner.where.column, 11);
  EXPECT_THAT(refusal("joints.position", type).text, HasSubstr("say which element"));
  EXPECT_THAT(refusal("timestamp[0]", type).text, HasSubstr("is not a list"));
  EXPECT_THAT(refusal("joints[0]", type).text, HasSubstr("is not a value"));
  EXPECT_THAT(refusal("joints[0].position.x", type).text, HasSubstr("has no fields"));
  EXPECT_THAT(refusal("joints[nom=\"a\"].position", type).text, HasSubstr("nom"));
}

TEST(FieldPath, whatIsNoPathIsRefusedWithItsPlace) {
  const auto& type = *foxglove::JointStates::descriptor();
  EXPECT_EQ(refusal("", type).where.column, 1);
  EXPECT_EQ(refusal("joints[0].", type).where.column, 11);
  EXPECT_EQ(refusal("joints[0", type).where.column, 7);
  EXPECT_EQ(refusal("joints[]", type).where.column, 8);
  EXPECT_EQ(refusal("joints[=\"x\"]", type).where.column, 8);
  EXPECT_EQ(refusal("joints[name=\"]", type).where.column, 7);
  EXPECT_EQ(refusal("joints+1", type).where.column, 7);
}

}  // namespace
}  // namespace robotlink
