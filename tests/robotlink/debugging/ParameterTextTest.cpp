// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ParameterText.h"

#include <gmock/gmock.h>

#include <functional>

#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace robotlink {
namespace {

using robotcontrol::DriveGoal;
using robotcontrol::DrivePath;

/// A text after the values in it were changed; the error if they cannot be.
template <typename M>
std::string edited(const std::string& text, const std::function<void(M&)>& change) {
  M before;
  EXPECT_TRUE(readParameterText(text, "a.textproto", before));
  M after = before;
  change(after);
  const auto result = editedParameterText(text, "a.textproto", before, after);
  return result ? *result : describe(result.error());
}

std::string editedGoal(const std::string& text, const std::function<void(DriveGoal&)>& change) {
  return edited<DriveGoal>(text, change);
}

}  // namespace

TEST(ParameterText, everyByteButTheValueStays) {
  EXPECT_EQ(
      editedGoal("# Where to.\n\nname :  \"home\"  # at last\n\tpose_in_field {\n  x: 1.50 ; # m\n\n}\n",
                 [](auto& goal) { goal.mutable_pose_in_field()->set_x(2.25); }),
      "# Where to.\n\nname :  \"home\"  # at last\n\tpose_in_field {\n  x: 2.25 ; # m\n\n}\n");
  EXPECT_EQ(editedGoal("pose_in_field <\tx\t: # why\n - 3, y: 1>any_heading: true",
                       [](auto& goal) {
                         goal.mutable_pose_in_field()->set_x(0.1);
                         goal.set_any_heading(false);
                       }),
            "pose_in_field <\tx\t: # why\n 0.1, y: 1>any_heading: false");
  EXPECT_EQ(editedGoal("name: \"a;\" # ü\n", [](auto& goal) { goal.set_name("b \"c\","); }),
            "name: \"b \\\"c\\\",\" # ü\n");
}

TEST(ParameterText, nothingChangesWithoutAnotherValue) {
  const std::string text = "pose_in_field { x: 1.000 } # the same\r\n";
  EXPECT_EQ(editedGoal(text, [](auto&) {}), text);
}

TEST(ParameterText, whatSomebodyElseChangedInTheFileStays) {
  DriveGoal before, after;
  before.mutable_pose_in_field()->set_y(1);
  after.mutable_pose_in_field()->set_y(2);
  const auto result = editedParameterText("pose_in_field { x: 7 y: 5 }", "a", before, after);
  ASSERT_TRUE(result);
  EXPECT_EQ(*result, "pose_in_field { x: 7 y: 2 }");
}

TEST(ParameterText, whatTheTextDoesNotHaveIsAddedAtTheEndOfItsMessage) {
  const auto add = [](DriveGoal& goal) { goal.mutable_pose_in_field()->set_y(2); };
  EXPECT_EQ(editedGoal("", add), "pose_in_field {\n  y: 2\n}\n");
  EXPECT_EQ(editedGoal("name: \"a\"", add), "name: \"a\"\npose_in_field {\n  y: 2\n}\n");
  EXPECT_EQ(editedGoal("pose_in_field { x: 1 }", add), "pose_in_field { x: 1 y: 2 }");
  EXPECT_EQ(editedGoal("pose_in_field {}", add), "pose_in_field { y: 2 }");
  EXPECT_EQ(editedGoal("pose_in_field {\n  x: 1  # m\n}\n", add),
            "pose_in_field {\n  x: 1  # m\n  y: 2\n}\n");
  EXPECT_EQ(edited<DrivePath>("goal {\n    name: 'a'\n  }", [&](auto& path) { add(*path.mutable_goal()); }),
            "goal {\n    name: 'a'\n    pose_in_field {\n      y: 2\n    }\n  }");
}

TEST(ParameterText, whatIsUnsetLeavesTheTextWithItsLine) {
  EXPECT_EQ(editedGoal("name: \"a\"\n  pose_in_field { x: 1 };\nany_heading: true\n",
                       [](auto& goal) { goal.clear_pose_in_field(); }),
            "name: \"a\"\nany_heading: true\n");
  EXPECT_EQ(edited<robotcontrol::Request>("id: 3 stop { engaged: true } # hold\n",
                                          [](auto& request) { request.mutable_send_tables(); }),
            "id: 3  # hold\nsend_tables {\n}\n");
}

TEST(ParameterText, elementsOfListsAreChangedInTheirPlaces) {
  const std::string two = "points_in_field { x: 1 } # first\npoints_in_field { x: 2 }\n";
  EXPECT_EQ(edited<DrivePath>(two, [](auto& path) { path.mutable_points_in_field(1)->set_x(5); }),
            "points_in_field { x: 1 } # first\npoints_in_field { x: 5 }\n");
  EXPECT_EQ(edited<DrivePath>("points_in_field [{ x: 1 }, { x: 2 }]",
                              [](auto& path) { path.mutable_points_in_field(1)->set_x(5); }),
            "points_in_field {\n  x: 1\n}\npoints_in_field {\n  x: 5\n}\n");
}

TEST(ParameterText, aTextThatCannotBeReadIsReportedWithItsPlace) {
  DriveGoal after;
  after.set_name("a");
  const auto result = editedParameterText("name: \"b\"\n  speed: 1\n", "a.textproto", DriveGoal(), after);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().front().where.file, "a.textproto");
  EXPECT_EQ(result.error().front().where.line, 2);
}

}  // namespace robotlink
