// SPDX-License-Identifier: GPL-3.0-or-later
// What `robotctl tune` searches with, and in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/robotctl/compare/Optimizer.h"
#include "app/robotctl/compare/ParameterSpace.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Solution.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A bowl whose bottom is in a corner of the cube, beside a worse one in the middle.
double bowl(const std::vector<double>& point) {
  double distance = 0, middle = 0;
  for (const double x : point) {
    distance += (x - 0.8) * (x - 0.8);
    middle += (x - 0.4) * (x - 0.4);
  }
  return std::min(distance, 0.05 + middle);
}

class OptimizerTest : public testing::TestWithParam<const char*> {};

TEST_P(OptimizerTest, findsBetterPointsTheSameWayEachTime) {
  std::vector<std::vector<double>> tried[2];
  for (auto& points : tried) {
    Optimizer{GetParam(), 120, 3}.minimize({0.7, 0.3, 0.6}, [&](const std::vector<double>& point) {
      points.push_back(point);
      return bowl(point);
    });
  }
  ASSERT_FALSE(tried[0].empty());
  EXPECT_EQ(tried[0], tried[1]);
  EXPECT_LE(tried[0].size(), 120U);
  double least = bowl(tried[0].front());
  for (const auto& point : tried[0]) {
    for (const double x : point) EXPECT_TRUE(x >= 0 && x <= 1);
    least = std::min(least, bowl(point));
  }
  EXPECT_LT(least, 0.6 * bowl({0.7, 0.3, 0.6}));
}

TEST_P(OptimizerTest, endsWhenThereIsNoCost) {
  int count = 0;
  Optimizer{GetParam(), 120, 3}.minimize({0.5, 0.5}, [&](const std::vector<double>& point) {
    return ++count < 7 ? std::optional(bowl(point)) : std::nullopt;
  });
  EXPECT_EQ(count, 7);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, OptimizerTest, testing::Values("crs2", "esch", "sbplx"),
                         [](const auto& test) { return std::string(test.param); });

/// A solution with the parameters of a goal: numbers, one of them in another message, and texts.
class ParameterSpaceTest : public testing::Test {
 protected:
  ParameterSpaceTest() {
    solution_.task = "driving";
    solution_.name = "there";
    solution_.parameters = &robotcontrol::DriveGoal::default_instance();
    folder_.write("driving.there.textproto", "name: \"home\" pose_in_field { x: 2 y: -1 }");
  }
  robotlink::Result<ParameterSpace> space(const std::vector<std::string>& texts) {
    auto parameters = robotlink::SolutionParameters::load(solution_, folder_.path(), {});
    EXPECT_TRUE(parameters);
    return ParameterSpace::of(texts, solution_, *parameters);
  }
  std::string error(const std::vector<std::string>& texts) {
    const auto made = space(texts);
    return made ? "" : made.error().text;
  }
  robotlink::SolutionDescription solution_;
  TestFolder folder_;
};

TEST_F(ParameterSpaceTest, numbersGoFromTheFileThroughTheCubeToAPreset) {
  const auto made = space({"pose_in_field.x=1:5", "pose_in_field.y"});
  ASSERT_TRUE(made) << made.error().text;
  ASSERT_EQ(made->axes().size(), 2U);
  EXPECT_EQ(made->axes()[1].low, -2) << "twice as much";
  EXPECT_EQ(made->axes()[1].high, -0.5);
  EXPECT_THAT(made->start(), ElementsAre(testing::DoubleEq(0.25), testing::DoubleNear(2.0 / 3, 1e-9)));
  EXPECT_THAT(made->numbersAt({0.5, 1}), ElementsAre("3", "-0.5"));
  const auto preset = made->presetAt({0.5, 1});
  const auto& values = *preset.parts[robotlink::Preset::kParameters];
  EXPECT_EQ(values.at("driving/there pose_in_field.x"), "3");
  EXPECT_EQ(values.size(), 2U);
}

TEST_F(ParameterSpaceTest, whatIsNoRangeOfANumberIsRefused) {
  EXPECT_THAT(error({"pose_in_field.z"}),
              HasSubstr("pose_in_field.z is not a numeric parameter of driving/there"));
  EXPECT_THAT(error({"name"}), HasSubstr("is not a numeric"));
  EXPECT_THAT(error({"pose_in_field"}), HasSubstr("is not a numeric"));
  EXPECT_THAT(error({"pose_in_field.x=1"}), HasSubstr("NAME=LOW:HIGH"));
  EXPECT_THAT(error({"pose_in_field.x=1:b"}), HasSubstr("NAME=LOW:HIGH"));
  EXPECT_THAT(error({"pose_in_field.x=3:1"}), HasSubstr("has no range"));
  EXPECT_THAT(error({"pose_in_field.x=3:4"}), HasSubstr("is 2 now, which is not between 3 and 4"));
  EXPECT_THAT(error({"pose_in_field.heading"}), HasSubstr("has no range"));
  EXPECT_THAT(error({"pose_in_field.x=1:2", "pose_in_field.x=1:3"}), HasSubstr("named twice"));
}

}  // namespace
}  // namespace app
