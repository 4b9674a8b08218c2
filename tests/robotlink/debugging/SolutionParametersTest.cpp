// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/SolutionParameters.h"

#include <gmock/gmock.h>

#include <limits>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Solution.h"
#include "tests/TestFolder.h"

namespace robotlink {
namespace {

using robotcontrol::DriveGoal;
using testing::HasSubstr;

/// The parameters of a solution that takes a goal, whose x has to be at least 1 and is 2 unless a file says
/// otherwise.
class SolutionParametersTest : public testing::Test {
 protected:
  SolutionParametersTest() {
    solution_.task = "drive";
    solution_.name = "straight";
    solution_.parameters = &DriveGoal::default_instance();
    solution_.parameterRules.builtIn = [](const RobotSetup&) {
      auto goal = std::make_unique<DriveGoal>();
      goal->mutable_pose_in_field()->set_x(2);
      goal->set_name("home");
      return goal;
    };
    solution_.parameterRules.ranges[{DriveGoal::kPoseInFieldFieldNumber, 1}] = {.minimum = 1};
  }
  tl::expected<SolutionParameters, Errors> load(const std::string& file) const {
    folder_.write("drive.straight.textproto", file);
    return SolutionParameters::load(solution_, folder_.path(), {});
  }
  static const DriveGoal& valuesOf(const SolutionParameters& parameters) {
    return dynamic_cast<const DriveGoal&>(*parameters.message());
  }
  static robotcontrol::PackageCopy goal(double x, const std::string& name = "") {
    DriveGoal values;
    values.mutable_pose_in_field()->set_x(x);
    values.set_name(name);
    robotcontrol::PackageCopy packed;
    packed.set_type(values.GetTypeName());
    packed.set_data(values.SerializeAsString());
    return packed;
  }

  const TestFolder folder_;
  SolutionDescription solution_;
};

TEST_F(SolutionParametersTest, whatTheFileLeavesOutIsBuiltIn) {
  const auto none = SolutionParameters::load(solution_, folder_.path(), {});
  ASSERT_TRUE(none);
  EXPECT_EQ(valuesOf(*none).pose_in_field().x(), 2);
  const auto some = load("pose_in_field { y: 5 }");
  ASSERT_TRUE(some) << describe(some.error());
  EXPECT_EQ(valuesOf(*some).pose_in_field().x(), 2);
  EXPECT_EQ(valuesOf(*some).pose_in_field().y(), 5);
  EXPECT_EQ(valuesOf(*some).name(), "home");
}

TEST_F(SolutionParametersTest, aMistakeInTheFileHasItsPlace) {
  const auto wrong = load("name: \"a\"\n  speed: 3\n");
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().front().where.file, HasSubstr("drive.straight.textproto"));
  EXPECT_EQ(wrong.error().front().where.line, 2);
  EXPECT_THAT(wrong.error().front().text, HasSubstr("speed"));
  EXPECT_FALSE(load("pose_in_field { y: inf }"));
}

TEST_F(SolutionParametersTest, aSolutionChecksWhatItIsGiven) {
  solution_.parameterRules.check = [](const google::protobuf::Message& message) -> std::string {
    return dynamic_cast<const DriveGoal&>(message).name() == "hell" ? "the way there is paved" : "";
  };
  auto parameters = SolutionParameters::load(solution_, {}, {});
  ASSERT_TRUE(parameters);
  EXPECT_TRUE(parameters->set(goal(3, "heaven")));
  auto clone = parameters->clone();
  for (SolutionParameters* each : {&*parameters, &clone}) {
    const auto done = each->set(goal(4, "hell"));
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().text, "the way there is paved");
    EXPECT_EQ(valuesOf(*each).name(), "heaven");
  }
}

TEST_F(SolutionParametersTest, aNumberOfTheFileThatMakesNoSenseIsAsBuiltIn) {
  const auto older = load("pose_in_field { x: 0.5 y: 5 }");
  ASSERT_TRUE(older);
  EXPECT_EQ(valuesOf(*older).pose_in_field().x(), 2);
  EXPECT_EQ(valuesOf(*older).pose_in_field().y(), 5);
}

TEST_F(SolutionParametersTest, whatIsRefusedChangesNothing) {
  auto parameters = load("pose_in_field { x: 3 }").value();
  robotcontrol::PackageCopy other = goal(4), damaged = goal(4);
  other.set_type("robotcontrol.DrivePath");
  damaged.set_data("\x0A\xFF");
  const auto refusal = [&](const robotcontrol::PackageCopy& value) {
    const auto result = parameters.set(value);
    return result ? "" : result.error().text;
  };
  EXPECT_EQ(refusal(goal(0.5)), "'pose_in_field.x' has to be at least 1");
  EXPECT_THAT(refusal(goal(std::numeric_limits<double>::quiet_NaN())), HasSubstr("not a finite number"));
  EXPECT_THAT(refusal(other), HasSubstr("not a 'robotcontrol.DrivePath'"));
  EXPECT_THAT(refusal(damaged), HasSubstr("the bytes are not a valid robotcontrol.DriveGoal"));
  EXPECT_EQ(valuesOf(parameters).pose_in_field().x(), 3);
}

TEST_F(SolutionParametersTest, whatIsSetReplacesAllAndTheRestIsBuiltIn) {
  auto parameters = load("pose_in_field { x: 3 y: 5 }").value();
  const auto* address = parameters.message();
  ASSERT_TRUE(parameters.set(goal(4, "there")));
  EXPECT_EQ(valuesOf(parameters).pose_in_field().x(), 4);
  EXPECT_EQ(valuesOf(parameters).pose_in_field().y(), 0) << "the file's value is gone";
  ASSERT_TRUE(parameters.restore(goal(0.5)));
  EXPECT_EQ(valuesOf(parameters).pose_in_field().x(), 2) << "a log may be older than the rules";
  EXPECT_EQ(valuesOf(parameters).name(), "home");
  const SolutionParameters moved = std::move(parameters);
  EXPECT_EQ(moved.message(), address) << "solutions refer to it";
}

TEST_F(SolutionParametersTest, itSaysItsFileItsLimitsAndWhatIsBuiltIn) {
  const auto parameters = load("pose_in_field { x: 3 }").value();
  robotcontrol::ParameterValues described;
  parameters.describe(described);
  EXPECT_EQ(described.file(), (folder_ / "drive.straight.textproto").string());
  ASSERT_EQ(described.limits_size(), 1);
  EXPECT_EQ(described.limits(0).path(), "pose_in_field.x");
  EXPECT_EQ(described.limits(0).minimum(), 1);
  DriveGoal builtIn;
  ASSERT_TRUE(builtIn.ParseFromString(described.built_in().data()));
  EXPECT_EQ(builtIn.pose_in_field().x(), 2);
}

TEST_F(SolutionParametersTest, whatWasSavedIsTheDefault) {
  auto parameters = load("pose_in_field { x: 3 }").value();
  ASSERT_TRUE(parameters.set(goal(4)));
  parameters.markSaved();
  ASSERT_TRUE(parameters.set(goal(5)));
  robotcontrol::ParameterValues described;
  parameters.describe(described);
  DriveGoal initial;
  ASSERT_TRUE(initial.ParseFromString(described.defaults().data()));
  EXPECT_EQ(initial.pose_in_field().x(), 4);
}

TEST_F(SolutionParametersTest, theDefaultIsWhatWasLoaded) {
  auto parameters = load("pose_in_field { x: 3 }").value();
  SolutionParameters copy = parameters.clone();
  ASSERT_TRUE(copy.set(goal(4)));
  EXPECT_EQ(valuesOf(parameters).pose_in_field().x(), 3) << "a copy is another one";
  robotcontrol::ParameterValues described;
  copy.describe(described);
  DriveGoal value, initial;
  ASSERT_TRUE(value.ParseFromString(described.value().data()));
  ASSERT_TRUE(initial.ParseFromString(described.defaults().data()));
  EXPECT_EQ(value.pose_in_field().x(), 4);
  EXPECT_EQ(initial.pose_in_field().x(), 3);
}

TEST_F(SolutionParametersTest, aSolutionWithoutParametersTakesNone) {
  solution_.parameters = nullptr;
  auto none = SolutionParameters::load(solution_, folder_.path(), {}).value();
  EXPECT_EQ(none.message(), nullptr);
  EXPECT_FALSE(none.set(goal(4)));
}

}  // namespace
}  // namespace robotlink
