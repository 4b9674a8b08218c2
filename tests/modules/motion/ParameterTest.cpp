// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "MotionParameters.pb.h"
#include "modules/motion/ParameterConversion.h"
#include "tests/modules/ParametersOf.h"

namespace modules {
namespace {

template <typename Message>
Message shipped(const std::string& name) {
  std::ifstream file(ROBOTCONTROL_SOURCE_DIR "/resources/parameters/ers210/" + name + ".textproto");
  std::stringstream text;
  text << file.rdbuf();
  Message message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text.str(), &message)) << name;
  return message;
}

/// How many fields of a message and of those inside it are not set.
int unsetFields(const google::protobuf::Message& message) {
  int unset = 0;
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const auto* field = message.GetDescriptor()->field(i);
    if (field->is_repeated()) {
      unset += message.GetReflection()->FieldSize(message, field) == 0;
    } else if (!message.GetReflection()->HasField(message, field)) {
      ++unset;
    } else if (field->cpp_type() == google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) {
      unset += unsetFields(message.GetReflection()->GetMessage(message, field));
    }
  }
  return unset;
}

TEST(ParameterTest, theShippedFilesSetEveryParameter) {
  for (const char* name : {"motion.wheel-model-rectangle", "motion.wheel-model-half-ellipse"}) {
    EXPECT_EQ(unsetFields(shipped<robotcontrol::GaitMotionParameters>(name)), 0) << name;
  }
  for (const char* name : {"head-control.search-and-track", "head-control.look-around"}) {
    EXPECT_EQ(unsetFields(shipped<robotcontrol::HeadControlParameters>(name)), 0) << name;
  }
}

TEST(ParameterTest, theBuiltInGaitIsTheShippedOne) {
  const auto message = shipped<robotcontrol::GaitMotionParameters>("motion.wheel-model-rectangle");
  EXPECT_EQ(gaitParameters(message, FootMode::kRectangle), GaitParameters{});
  EXPECT_EQ(motionOptions(message), MotionEngine::Options{});
}

TEST(ParameterTest, whatIsNotSetKeepsItsValue) {
  robotcontrol::GaitMotionParameters message;
  EXPECT_EQ(gaitParameters(message, FootMode::kRectangle), GaitParameters{});
  message.mutable_gait()->mutable_hind()->set_lift(0.02);
  message.mutable_gait()->set_factor_x(0);
  const GaitParameters gait = gaitParameters(message, FootMode::kHalfEllipse);
  EXPECT_EQ(gait.hindLift, 0.02);
  EXPECT_EQ(gait.factorX, 0);
  EXPECT_EQ(gait.foreLift, GaitParameters{}.foreLift);
  EXPECT_EQ(gait.footMode, FootMode::kHalfEllipse);
  EXPECT_EQ(headParameters({}), HeadParameters{});
}

TEST(ParameterTest, whatWouldBreakAGaitIsIgnored) {
  robotcontrol::GaitMotionParameters message;
  auto& gait = *message.mutable_gait();
  gait.set_step_frames(0);
  gait.set_maximum_x(-1);
  gait.set_counter_forward_until(-0.1);
  gait.mutable_fore()->set_ground_phase(1.5);
  gait.mutable_hind()->set_lift_phase(0.45);
  gait.mutable_hind()->set_ground_phase(0.5);
  gait.add_leg_phases(0.3);
  message.set_blend_time(-1);
  EXPECT_EQ(gaitParameters(message, FootMode::kRectangle), GaitParameters{});
  EXPECT_EQ(motionOptions(message), MotionEngine::Options{});
}

TEST(ParameterTest, zeroIsUsedWhereItMakesSense) {
  robotcontrol::GaitMotionParameters motion;
  motion.set_blend_time(0);
  motion.set_head_speed_share(0);
  EXPECT_EQ(motionOptions(motion).blendTime, 0);
  EXPECT_EQ(motionOptions(motion).headSpeedShare, 0);
  robotcontrol::HeadControlParameters head;
  head.set_lost_after(0);
  head.set_sweep_speed(0);
  EXPECT_EQ(headParameters(head).lostAfter, 0);
  EXPECT_EQ(headParameters(head).sweepSpeed, 0);
}

TEST(ParameterTest, whatWouldBreakAGaitIsRefusedWithAReason) {
  ParametersOf<robotcontrol::GaitMotionParameters> parameters("motion", "wheel-model-rectangle");
  robotcontrol::GaitMotionParameters values;
  values.mutable_gait()->set_maximum_x(0);
  EXPECT_EQ(parameters.set(values), "'gait.maximum_x' has to be more than 0");
  values.mutable_gait()->set_maximum_x(0.1);
  values.mutable_gait()->mutable_hind()->set_lift_phase(1.5);
  EXPECT_EQ(parameters.set(values), "'gait.hind.lift_phase' has to be more than 0 and at most 1");
  values.mutable_gait()->mutable_hind()->set_lift_phase(0.1);
  EXPECT_EQ(parameters.set(values), "");
  EXPECT_EQ(parameters.values().gait().maximum_x(), 0.1);
}

}  // namespace
}  // namespace modules
