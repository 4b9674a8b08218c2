// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/expressions/NumericFields.h"

#include <gmock/gmock.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/robotlink/packages/ForeignTime.h"

using namespace robotlink;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

namespace {

foxglove::JointStates joints() {
  foxglove::JointStates states;
  states.mutable_timestamp()->set_seconds(3);
  states.mutable_timestamp()->set_nanos(500'000'000);
  auto& pan = *states.add_joints();
  pan.set_name("head/pan.1");
  pan.set_position(0.25);
  states.add_joints()->set_velocity(-1);
  return states;
}

}  // namespace

TEST(NumericFields, ofAPlotValueTheyAreItsTimeAndItsValue) {
  EXPECT_THAT(numericFields(*robotcontrol::PlotValue::descriptor()), ElementsAre("timestamp", "value"));
}

TEST(NumericFields, aTypesFieldsAreListedThroughPartsAndElements) {
  const auto fields = numericFields(*foxglove::JointStates::descriptor());
  EXPECT_THAT(fields, Contains("joints[0].position"));
  EXPECT_THAT(fields, Contains("joints[31].effort"));
  EXPECT_THAT(fields, Not(Contains("joints[32].effort")));
  EXPECT_THAT(fields, Not(Contains("joints[0].name")));
}

TEST(NumericFields, aMessagesFieldsAreThoseThatItHasByTheNamesOfItsElements) {
  EXPECT_THAT(numericFields(joints()),
              ElementsAre("timestamp", "joints[head/pan.1].position", "joints[1].velocity"));
}

TEST(NumericFields, anElementWithTheNameOfAnotherOneIsListedByItsIndex) {
  foxglove::JointStates states;
  for (int i = 0; i < 3; ++i) {
    auto& joint = *states.add_joints();
    joint.set_name(i == 1 ? "other" : "same");
    joint.set_position(i);
  }
  EXPECT_THAT(numericFields(states),
              ElementsAre("joints[same].position", "joints[other].position", "joints[2].position"));
}

TEST(NumericFields, whatIsListedIsFound) {
  const foxglove::JointStates states = joints();
  for (const std::string& path : numericFields(states))
    EXPECT_TRUE(numberAt(states, path).has_value()) << path;
  EXPECT_EQ(numberAt(states, "timestamp"), 3.5);
  EXPECT_EQ(numberAt(states, "joints[0].position"), 0.25);
  EXPECT_EQ(numberAt(states, "joints[head/pan.1].position"), 0.25);
  EXPECT_EQ(numberAt(states, "joints[1].velocity"), -1);
}

TEST(NumericFields, integersBoolsAndEnumerationsCount) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_in_use(true);
  key.mutable_mode()->set_kind(robotcontrol::KeyMode::EVERY_N);
  key.mutable_mode()->set_n(4'000'000'000U);
  EXPECT_EQ(numberAt(table, "keys[0].in_use"), 1);
  EXPECT_EQ(numberAt(table, "keys[0].mode.kind"), 3);
  EXPECT_EQ(numberAt(table, "keys[0].mode.n"), 4e9);
  foxglove::LinePrimitive line;
  line.add_indices(7);
  EXPECT_EQ(numberAt(line, "indices[0]"), 7);
}

TEST(NumericFields, pathsThatLeadNowhereFindNothing) {
  const foxglove::JointStates states = joints();
  for (const char* path :
       {"", ".", "x", "joints[0]", "joints[2].position", "joints[-1].position",
        "joints[99999999999].position", "joints[].position", "joints[0", "joints[0]position", "joints[0].",
        "joints[0].name", "joints[nobody].position", "joints[1].position", "timestamp.seconds.x",
        "timestamp[0]", "joints[0]..position", "[0]", "joints[0].position.x"}) {
    EXPECT_FALSE(numberAt(states, path).has_value()) << path;
  }
  EXPECT_FALSE(numberAt(robotcontrol::DebugMessage(), "plot.value").has_value()) << "a part that is not set";
}

TEST(NumericFields, aTypeOfManyFieldsIsListedUpToABound) {
  EXPECT_LE(numericFields(*foxglove::SceneUpdate::descriptor()).size(), 1000U);
  foxglove::ImageAnnotations huge;
  for (int i = 0; i < 5000; ++i) huge.add_circles()->set_diameter(i);
  EXPECT_EQ(numericFields(huge).size(), 1000U);
}

TEST(NumericFields, aForeignTypeThatIsOnlyCalledTimestampIsNoTime) {
  test::ForeignTime foreign;
  EXPECT_FALSE(numberAt(foreign.message(), "stamp"));
  EXPECT_THAT(numericFields(foreign.message()), testing::IsEmpty());
}
