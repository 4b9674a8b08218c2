// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/FieldLandmarks.h"

#include <gmock/gmock.h>

namespace modules {
namespace {

robotlink::FieldDescription smallField() {
  robotlink::FieldDescription field;
  field.palette = {{"green", {0, 130, 50}},
                   {"yellow", {250, 215, 0}},
                   {"skyblue", {40, 165, 235}},
                   {"pink", {250, 90, 160}},
                   {"carpet-edge", {1, 2, 3}}};
  field.goalDepth = 0.4;
  field.goals.resize(2);
  field.goals[0].name = "own";
  field.goals[0].color = "yellow";
  field.goals[0].x = -2.1;
  field.goals[1].name = "other";
  field.goals[1].color = "skyblue";
  field.goals[1].x = 2.1;
  field.beacons.resize(2);
  field.beacons[0].name = "left";
  field.beacons[0].topColor = "pink";
  field.beacons[0].bottomColor = "yellow";
  field.beacons[0].position = {1, 1.5};
  field.beacons[1].name = "odd";
  field.beacons[1].topColor = "pink";
  field.beacons[1].bottomColor = "violet";
  return field;
}

TEST(FieldLandmarks, classesAreThoseTheProgramKnowsInItsOwnOrder) {
  EXPECT_THAT(fieldClasses(smallField()).names(), testing::ElementsAre("pink", "yellow", "skyblue", "green"));
}

TEST(FieldLandmarks, beaconsComeBeforeGoalsWithTheClassesOfTheirBands) {
  const auto field = smallField();
  const auto landmarks = fieldLandmarks(field, fieldClasses(field));
  ASSERT_EQ(landmarks.size(), 3U) << "the beacon with a color that is no class is dropped";
  EXPECT_EQ(landmarks[0].name, "left");
  EXPECT_EQ(landmarks[0].kind, FieldLandmark::Kind::kBeacon);
  EXPECT_EQ(landmarks[0].topClass, 1);
  EXPECT_EQ(landmarks[0].bottomClass, 2);
  EXPECT_EQ(landmarks[1].kind, FieldLandmark::Kind::kGoal);
  EXPECT_EQ(landmarks[1].topClass, landmarks[1].bottomClass);
}

TEST(FieldLandmarks, aGoalIsInTheMiddleOfItsFloor) {
  const auto field = smallField();
  const auto landmarks = fieldLandmarks(field, fieldClasses(field));
  EXPECT_NEAR(landmarks[1].position.x(), -2.3, 1e-9);
  EXPECT_NEAR(landmarks[2].position.x(), 2.3, 1e-9);
}

TEST(FieldLandmarks, theFirstTableKnowsTheColorsOfTheField) {
  const auto field = smallField();
  const auto classes = fieldClasses(field);
  const colortool::ColorTable table = fieldColorTable(field, classes, {});
  for (const auto& color : field.palette) {
    if (classes.index(color.name) == 0) continue;
    EXPECT_EQ(table.classOf(robotlink::toYCbCr(color.rgb)), classes.index(color.name)) << color.name;
  }
}

}  // namespace
}  // namespace modules
