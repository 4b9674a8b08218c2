// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/FieldModel.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "robotlink/base/AtomicFile.h"

namespace app {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const char* const kField = ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml";
const char* const kModel = ROBOTCONTROL_SOURCE_DIR "/resources/scenes/models/field2002/model.sdf";

robotlink::FieldDescription field() {
  return robotlink::FieldDescription::load(kField).value();
}

TEST(FieldModel, theShippedModelIsTheOneGeneratedFromTheField) {
  const std::string generated = fieldModelSdf(field(), "2002");
  if (std::getenv("ROBOTCONTROL_REGENERATE") != nullptr) {
    ASSERT_TRUE(robotlink::writeFileAtomically(kModel, generated));
  }
  const auto shipped = robotlink::readFile(kModel);
  ASSERT_TRUE(shipped) << shipped.error().describe();
  EXPECT_EQ(*shipped, generated) << "run this test with ROBOTCONTROL_REGENERATE=1 to write the model again";
}

TEST(FieldModel, aFieldWithoutWallsHasLinesAroundItInstead) {
  const auto open = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2009.yaml");
  ASSERT_TRUE(open);
  const std::string text = fieldModelSdf(*open, "2009");
  EXPECT_THAT(text,
              AllOf(HasSubstr("line_touch_left"), HasSubstr("line_own_end"), HasSubstr("goal_blue_back")));
  EXPECT_THAT(text, Not(HasSubstr("wall_")));
  EXPECT_THAT(text, Not(HasSubstr("corner_")));
  EXPECT_THAT(fieldModelSdf(field(), "2002"), Not(HasSubstr("line_touch")));
}

TEST(FieldModel, aChangedFieldChangesTheModel) {
  robotlink::FieldDescription changed = field();
  changed.beacons[0].topColor = "orange";
  changed.wallHeight = 0.123;
  const std::string text = fieldModelSdf(changed, "2002");
  EXPECT_THAT(text, HasSubstr(" 0.123</size>"));
  EXPECT_NE(text, fieldModelSdf(field(), "2002"));
}

TEST(FieldModel, linesCannotBeTouched) {
  EXPECT_THAT(fieldModelSdf(field(), "2002"), HasSubstr("visual name=\"line_halfway\""));
  EXPECT_THAT(fieldModelSdf(field(), "2002"), Not(HasSubstr("collision name=\"line_")));
}

}  // namespace
}  // namespace app
