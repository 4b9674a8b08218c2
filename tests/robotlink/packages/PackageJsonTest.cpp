// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PackageJson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/packages/PackageTypes.h"

using namespace robotlink;
using ::testing::HasSubstr;

namespace {

TEST(PackageJson, everyPackageHasATemplateThatCanBeRead) {
  for (const auto& [name, type] : ownPackageTypes()) {
    const auto read = packageFromJson(name, packageTemplate(name));
    ASSERT_TRUE(read) << name << ": " << read.error().text;
    EXPECT_EQ(read->type(), type->full_name());
  }
  EXPECT_EQ(packageTemplate("models/nothing"), "{}");
}

TEST(PackageJson, fieldsBecomeAPackage) {
  const auto read = packageFromJson("models/pose", R"({"robot_in_field": {"x": 1.5}})");
  ASSERT_TRUE(read) << read.error().text;
  robotcontrol::RobotPose pose;
  ASSERT_TRUE(pose.ParseFromString(read->data()));
  EXPECT_EQ(pose.robot_in_field().x(), 1.5);
  EXPECT_TRUE(packageFromJson("models/pose", ""));
}

TEST(PackageJson, whatIsNoSuchPackageIsRefusedWithThePathOfTheField) {
  const auto unknown = packageFromJson("models/pose", R"({"robot_in_field": {"speed": 1}})");
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().text, HasSubstr("robot_in_field"));
  EXPECT_THAT(unknown.error().text, HasSubstr("speed"));
  const auto wrong = packageFromJson("models/pose", R"({"robot_in_field": {"x": "far"}})");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().text, HasSubstr("robot_in_field.x"));
  EXPECT_THAT(packageFromJson("models/poze", "").error().text, HasSubstr("models/pose"));
  EXPECT_FALSE(packageFromJson("models/pose", std::string(2U << 20U, ' ')));
}

}  // namespace
